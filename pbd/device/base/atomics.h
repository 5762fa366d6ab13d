// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Atomics on integers alone. Their results do not depend on the order of the operations, so runs stay
// reproducible.
#pragma once

#include <cstdint>
#ifndef __CUDA_ARCH__
#include <atomic>
#endif

#include "pbd/device/base/qualifiers.h"

namespace meniscus::pbd {

MENISCUS_HD inline void atomic_max(uint32_t& target, uint32_t value) {
#ifdef __CUDA_ARCH__
  if (value > target) atomicMax(&target, value);  // rarely true, so a plain read comes first
#else
  std::atomic_ref<uint32_t> shared(target);
  uint32_t seen = shared.load(std::memory_order_relaxed);
  while (seen < value && !shared.compare_exchange_weak(seen, value, std::memory_order_relaxed)) {
  }
#endif
}

/// Returns the previous value, which does depend on the order.
MENISCUS_HD inline uint32_t atomic_add(uint32_t& target, uint32_t value) {
#ifdef __CUDA_ARCH__
  return atomicAdd(&target, value);
#else
  return std::atomic_ref<uint32_t>(target).fetch_add(value, std::memory_order_relaxed);
#endif
}

MENISCUS_HD inline void atomic_add(int64_t& target, int64_t value) {
#ifdef __CUDA_ARCH__
  atomicAdd(reinterpret_cast<unsigned long long*>(&target), static_cast<unsigned long long>(value));
#else
  std::atomic_ref<int64_t>(target).fetch_add(value, std::memory_order_relaxed);
#endif
}

MENISCUS_HD inline void atomic_min(uint32_t& target, uint32_t value) {
#ifdef __CUDA_ARCH__
  if (value < target) atomicMin(&target, value);
#else
  std::atomic_ref<uint32_t> shared(target);
  uint32_t seen = shared.load(std::memory_order_relaxed);
  while (seen > value && !shared.compare_exchange_weak(seen, value, std::memory_order_relaxed)) {
  }
#endif
}

/// The value of `target`, while other threads may write it.
template <class T>
MENISCUS_HD T atomic_load(T& target) {
#ifdef __CUDA_ARCH__
  return *static_cast<volatile T*>(&target);
#else
  return std::atomic_ref<T>(target).load(std::memory_order_relaxed);
#endif
}

/// Writes `value` where other threads may read or write.
template <class T>
MENISCUS_HD void atomic_store(T& target, T value) {
#ifdef __CUDA_ARCH__
  *static_cast<volatile T*>(&target) = value;
#else
  std::atomic_ref<T>(target).store(value, std::memory_order_relaxed);
#endif
}

/// Writes `value` if `expected` is stored. Returns the previous value, which does depend on the order.
MENISCUS_HD inline uint32_t atomic_exchange_if(uint32_t& target, uint32_t expected, uint32_t value) {
#ifdef __CUDA_ARCH__
  return atomicCAS(&target, expected, value);
#else
  std::atomic_ref<uint32_t>(target).compare_exchange_strong(expected, value, std::memory_order_relaxed);
  return expected;
#endif
}

MENISCUS_HD inline uint64_t atomic_exchange_if(uint64_t& target, uint64_t expected, uint64_t value) {
#ifdef __CUDA_ARCH__
  return atomicCAS(reinterpret_cast<unsigned long long*>(&target), expected, value);
#else
  std::atomic_ref<uint64_t>(target).compare_exchange_strong(expected, value, std::memory_order_relaxed);
  return expected;
#endif
}

/// Reserves n elements at the end of a list. Returns where they begin, which depends on the order. On a GPU,
/// the threads of a warp that ask together use one atomic operation, as one address serves one at a time.
MENISCUS_HD inline uint32_t append(uint32_t& size, uint32_t n) {
#ifdef __CUDA_ARCH__
  const unsigned together = __activemask(), lane = threadIdx.x & 31;
  uint32_t before = 0, total = 0;
  for (unsigned left = together; left; left &= left - 1) {
    const int from = __ffs(static_cast<int>(left)) - 1;
    const uint32_t theirs = __shfl_sync(together, n, from);
    if (static_cast<unsigned>(from) < lane) before += theirs;
    total += theirs;
  }
  const int leader = __ffs(static_cast<int>(together)) - 1;
  uint32_t first = 0;
  if (lane == static_cast<unsigned>(leader)) first = atomicAdd(&size, total);
  return __shfl_sync(together, first, leader) + before;
#else
  return atomic_add(size, n);
#endif
}

}  // namespace meniscus::pbd
