// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Four or eight threads of a warp, or a whole warp, that work on one particle. Each thread has one of the
// lanes that device/cpu/lanes.h keeps in a register, so the same kernels run over either. Teams serve work
// that is long for one thread, such as a long neighbour list, and particles too few to fill the GPU.
#pragma once

#include <cstdint>

#include "pbd/device/base/view.h"
#include "pbd/device/cuda/batch.h"
#include "pbd/device/scalar.h"
#include "pbd/math/vec.h"

namespace meniscus::pbd {

/// The lane of a thread within its team.
template <uint32_t lanes>
MENISCUS_HD uint32_t team_rank() {
#ifdef __CUDA_ARCH__
  return threadIdx.x % lanes;
#else
  return 0;
#endif
}

/// The mask of the warp's lanes that form this thread's team.
template <uint32_t lanes>
MENISCUS_HD uint32_t team_mask() {
#ifdef __CUDA_ARCH__
  return (~0u >> (32 - lanes)) << (threadIdx.x % 32 / lanes * lanes);
#else
  return 1;
#endif
}

/// This thread's lane.
template <uint32_t lanes>
struct TeamFloat {
  float value;

  TeamFloat() = default;
  MENISCUS_HD TeamFloat(float v) : value(v) {}

  MENISCUS_HD friend TeamFloat operator+(TeamFloat a, TeamFloat b) { return a.value + b.value; }
  MENISCUS_HD friend TeamFloat operator-(TeamFloat a, TeamFloat b) { return a.value - b.value; }
  MENISCUS_HD friend TeamFloat operator*(TeamFloat a, TeamFloat b) { return a.value * b.value; }
  MENISCUS_HD friend TeamFloat operator/(TeamFloat a, TeamFloat b) { return a.value / b.value; }
  MENISCUS_HD friend TeamFloat& operator+=(TeamFloat& a, TeamFloat b) { return a = a + b; }
  MENISCUS_HD friend TeamFloat& operator*=(TeamFloat& a, TeamFloat b) { return a = a * b; }
  MENISCUS_HD friend TeamFloat max(TeamFloat a, TeamFloat b) { return pbd::max(a.value, b.value); }
  MENISCUS_HD friend TeamFloat select_less(TeamFloat x, TeamFloat y, TeamFloat a, TeamFloat b) {
    return x.value < y.value ? a : b;
  }
  MENISCUS_HD friend TeamFloat inverse_sqrt(TeamFloat a) { return pbd::inverse_sqrt(a.value); }
  MENISCUS_HD friend TeamFloat unit_part(TeamFloat a) { return pbd::unit_part(a.value); }

  /// The sum over the team, by halves: every thread gets it, with the same bits each time.
  MENISCUS_HD friend float sum(TeamFloat a) {
#ifdef __CUDA_ARCH__
    MENISCUS_UNROLL
    for (uint32_t step = lanes / 2; step > 0; step /= 2)
      a.value += __shfl_xor_sync(team_mask<lanes>(), a.value, step);
#endif
    return a.value;
  }
};

/// The neighbour of this thread.
template <uint32_t lanes>
struct TeamIndex {
  uint32_t j;
};

template <uint32_t lanes>
MENISCUS_HD Vec4Of<TeamFloat<lanes>> gather(View<const Vec4> from, TeamIndex<lanes> i) {
  const Vec4 v = load(from, i.j);
  return {v.x, v.y, v.z, v.w};
}
template <uint32_t lanes>
MENISCUS_HD TeamFloat<lanes> gather(View<const float> from, TeamIndex<lanes> i) {
  return from[i.j];
}

/// The device type of kernels that a team runs.
template <uint32_t lanes>
struct CudaTeamOf {
  using Real = TeamFloat<lanes>;
  using Index = TeamIndex<lanes>;
  using Lister = CudaLister<8>;
  static constexpr uint32_t lane_count = lanes;

  MENISCUS_HD static uint32_t rank() { return team_rank<lanes>(); }
  /// True in the one thread of a team that may write results that all of them have.
  MENISCUS_HD static bool leads() { return rank() == 0; }
};

using CudaTeam = CudaTeamOf<8>;
using CudaHalfTeam = CudaTeamOf<4>;
using CudaWarp = CudaTeamOf<32>;

template <class D>
inline constexpr bool is_cuda_team = false;
template <uint32_t lanes>
inline constexpr bool is_cuda_team<CudaTeamOf<lanes>> = true;

/// Bit k: whether `so` is true in thread k of a team of eight.
MENISCUS_HD inline uint32_t votes_of_team(bool so) {
#ifdef __CUDA_ARCH__
  return __ballot_sync(team_mask<8>(), so) >> (threadIdx.x % 32 / 8 * 8) & 0xff;
#else
  return so;
#endif
}

/// The value of thread `lane` of a team of eight.
MENISCUS_HD inline uint32_t from_lane_of_team(uint32_t value, [[maybe_unused]] uint32_t lane) {
#ifdef __CUDA_ARCH__
  return __shfl_sync(team_mask<8>(), value, static_cast<int>(lane), 8);
#else
  return value;
#endif
}

}  // namespace meniscus::pbd
