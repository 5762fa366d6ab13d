// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Eight threads of a warp that work on one particle, each with one lane of what device/cpu/lanes.h has in a
// register: the same kernels run over either. For work that one thread would take too long over, such as a
// long neighbour list, and for few particles, which would not fill the GPU.
#pragma once

#include <cstdint>

#include "pbd/device/cuda/batch.h"
#include "pbd/device/scalar.h"
#include "pbd/device/view.h"
#include "pbd/math/vec.h"

namespace meniscus::pbd {

/// This thread's lane of eight.
struct TeamFloat {
  float value;

  TeamFloat() = default;
  MENISCUS_HD TeamFloat(float v) : value(v) {}
};

MENISCUS_HD inline TeamFloat operator+(TeamFloat a, TeamFloat b) {
  return a.value + b.value;
}
MENISCUS_HD inline TeamFloat operator-(TeamFloat a, TeamFloat b) {
  return a.value - b.value;
}
MENISCUS_HD inline TeamFloat operator*(TeamFloat a, TeamFloat b) {
  return a.value * b.value;
}
MENISCUS_HD inline TeamFloat operator/(TeamFloat a, TeamFloat b) {
  return a.value / b.value;
}
MENISCUS_HD inline TeamFloat& operator+=(TeamFloat& a, TeamFloat b) {
  return a = a + b;
}
MENISCUS_HD inline TeamFloat& operator*=(TeamFloat& a, TeamFloat b) {
  return a = a * b;
}
MENISCUS_HD inline TeamFloat max(TeamFloat a, TeamFloat b) {
  return max(a.value, b.value);
}
MENISCUS_HD inline TeamFloat select_less(TeamFloat x, TeamFloat y, TeamFloat a, TeamFloat b) {
  return x.value < y.value ? a : b;
}
MENISCUS_HD inline TeamFloat inverse_sqrt(TeamFloat a) {
  return inverse_sqrt(a.value);
}
MENISCUS_HD inline TeamFloat unit_part(TeamFloat a) {
  return unit_part(a.value);
}

/// Which lane of its team a thread has.
MENISCUS_HD inline uint32_t team_rank() {
#ifdef __CUDA_ARCH__
  return threadIdx.x & 7;
#else
  return 0;
#endif
}

/// The warp's lanes that make up this thread's team.
MENISCUS_HD inline uint32_t team_mask() {
#ifdef __CUDA_ARCH__
  return 0xffu << (threadIdx.x & 24);
#else
  return 1;
#endif
}

/// The sum over the team, by halves: every thread gets it, with the same bits each time.
MENISCUS_HD inline float sum(TeamFloat a) {
#ifdef __CUDA_ARCH__
  a.value += __shfl_xor_sync(team_mask(), a.value, 4);
  a.value += __shfl_xor_sync(team_mask(), a.value, 2);
  a.value += __shfl_xor_sync(team_mask(), a.value, 1);
#endif
  return a.value;
}

/// The neighbour that this thread has of eight.
struct TeamIndex {
  uint32_t j;
};

MENISCUS_HD inline Vec4Of<TeamFloat> gather(View<const Vec4> from, TeamIndex i) {
  const Vec4 v = load(from, i.j);
  return {v.x, v.y, v.z, v.w};
}
MENISCUS_HD inline TeamFloat gather(View<const float> from, TeamIndex i) {
  return from[i.j];
}

/// The sum over the team's threads before this one, and over all.
struct TeamPlace {
  uint32_t before, total;
};

MENISCUS_HD inline TeamPlace place_in_team(uint32_t n) {
#ifdef __CUDA_ARCH__
  uint32_t sum = n;
  for (uint32_t step = 1; step < 8; step *= 2) {
    const uint32_t lower = __shfl_up_sync(team_mask(), sum, step, 8);
    if (team_rank() >= step) sum += lower;
  }
  return {sum - n, __shfl_sync(team_mask(), sum, 7, 8)};
#else
  return {0, n};
#endif
}

/// Whether it is so for any thread of the team.
MENISCUS_HD inline bool any_in_team(bool so) {
#ifdef __CUDA_ARCH__
  return __any_sync(team_mask(), so) != 0;
#else
  return so;
#endif
}

/// What a kernel is a template over when a team runs it.
struct CudaTeam {
  using Real = TeamFloat;
  using Lister = CudaLister<8>;
  static constexpr uint32_t lane_count = 8;

  /// True in the one thread of a team that may write what all of them know.
  MENISCUS_HD static bool leads() { return team_rank() == 0; }
};

}  // namespace meniscus::pbd
