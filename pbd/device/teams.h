// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Threads that share one item's work: several of a GPU's warp, or the CPU's single thread. All threads of a
// team call the kernel with the same item. Each takes every count()-th part of the work, from its rank on.
// Exchanges run in a fixed order, so that the bits are the same each time.
#pragma once

#include <cstdint>

#include "pbd/device/base/qualifiers.h"
#include "pbd/device/device.h"
#include "pbd/math/vec.h"

namespace meniscus::pbd {

/// All threads of a team must call each of these together. `size` is a power of 2 up to 32.
template <uint32_t size>
struct Team {
  static constexpr uint32_t most = size;  // threads, on a GPU

#ifdef __CUDA_ARCH__
  MENISCUS_HD static constexpr uint32_t count() {
    return size;
  }
  MENISCUS_HD static uint32_t rank() {
    return threadIdx.x % size;
  }
  /// The first thread's lane in the warp.
  MENISCUS_HD static uint32_t first() {
    return threadIdx.x % 32 / size * size;
  }
  MENISCUS_HD static uint32_t mask() {
    return (0xffffffffu >> (32 - size)) << first();
  }
#else
  MENISCUS_HD static constexpr uint32_t count() {
    return 1;
  }
  MENISCUS_HD static uint32_t rank() {
    return 0;
  }
#endif
  /// True in the one thread that writes results that all of them have.
  MENISCUS_HD static bool leads() {
    return rank() == 0;
  }

  /// Makes the writes of each thread visible to the others.
  MENISCUS_HD static void sync() {
#ifdef __CUDA_ARCH__
    __syncwarp(mask());
#endif
  }

  /// Bit k is set where `so` is true in thread k.
  MENISCUS_HD static uint32_t ballot(bool so) {
#ifdef __CUDA_ARCH__
    return (__ballot_sync(mask(), so) & mask()) >> first();
#else
    return so;
#endif
  }
  MENISCUS_HD static bool any(bool so) {
    return ballot(so) != 0;
  }

  /// The value of thread `rank`.
  MENISCUS_HD static uint32_t from(uint32_t rank, uint32_t value) {
#ifdef __CUDA_ARCH__
    return __shfl_sync(mask(), value, static_cast<int>(rank), size);
#else
    (void)rank;
    return value;
#endif
  }
  MENISCUS_HD static float from(uint32_t rank, float value) {
#ifdef __CUDA_ARCH__
    return __shfl_sync(mask(), value, static_cast<int>(rank), size);
#else
    (void)rank;
    return value;
#endif
  }
  MENISCUS_HD static Vec3 from(uint32_t rank, Vec3 v) {
    return {from(rank, v.x), from(rank, v.y), from(rank, v.z)};
  }

  /// The sum over all threads, by halves; each gets it.
  template <class T>
  MENISCUS_HD static T sum(T value) {
#ifdef __CUDA_ARCH__
    for (uint32_t step = size / 2; step > 0; step /= 2) value += __shfl_xor_sync(mask(), value, step);
#endif
    return value;
  }
  MENISCUS_HD static Vec3 sum(Vec3 v) {
    return {sum(v.x), sum(v.y), sum(v.z)};
  }

  /// The least value of all threads; each gets it.
  MENISCUS_HD static float least(float value) {
#ifdef __CUDA_ARCH__
    for (uint32_t step = size / 2; step > 0; step /= 2)
      value = pbd::min(value, __shfl_xor_sync(mask(), value, step));
#endif
    return value;
  }
  MENISCUS_HD static Vec3 least(Vec3 v) {
    return {least(v.x), least(v.y), least(v.z)};
  }

  /// The sum over the threads before this one.
  MENISCUS_HD static uint32_t sum_before(uint32_t n) {
#ifdef __CUDA_ARCH__
    uint32_t sum = n;
    for (uint32_t step = 1; step < size; step *= 2) {
      const uint32_t lower = __shfl_up_sync(mask(), sum, step, size);
      if (rank() >= step) sum += lower;
    }
    return sum - n;
#else
    (void)n;
    return 0;
#endif
  }
};

template <class T, class Kernel>
struct RunTeams {
  Kernel kernel;

  MENISCUS_HD void operator()(uint32_t thread) const { kernel(thread / T::count()); }
};

/// Runs kernel(i) with a team T for each i below `count`.
template <class T, class D, class Kernel>
void parallel_for_teams(D& device, const char* name, uint32_t count, const Kernel& kernel) {
  const uint32_t threads = device.kind() == DeviceKind::cpu ? 1 : T::most;
  device.parallel_for(name, threads * count, RunTeams<T, Kernel>{kernel});
}

}  // namespace meniscus::pbd
