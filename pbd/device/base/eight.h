// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of eight boxes at once, with their coordinates side by side (aligned to 16 bytes).
#pragma once

#include <cstdint>

#include "pbd/device/base/qualifiers.h"

#if defined(__SSE2__) && !defined(__CUDACC__)
#include <emmintrin.h>
#endif

namespace meniscus::pbd {

/// Tests eight boxes, with each axis side by side, against the box from `least` to `most`. Bit k is set where
/// box k overlaps.
MENISCUS_HD inline uint32_t overlap_mask(const float (&lower)[3][8], const float (&upper)[3][8],
                                         const float (&least)[3], const float (&most)[3]) {
#if defined(__SSE2__) && !defined(__CUDACC__)
  // Combined as lanes, so that two masks are extracted instead of twelve.
  uint32_t mask = 0;
  for (int four = 0; four < 8; four += 4) {
    __m128 so = _mm_castsi128_ps(_mm_set1_epi32(-1));
    for (int axis = 0; axis < 3; ++axis) {
      so = _mm_and_ps(so, _mm_cmple_ps(_mm_load_ps(lower[axis] + four), _mm_set1_ps(most[axis])));
      so = _mm_and_ps(so, _mm_cmpge_ps(_mm_load_ps(upper[axis] + four), _mm_set1_ps(least[axis])));
    }
    mask |= static_cast<uint32_t>(_mm_movemask_ps(so)) << four;
  }
  return mask;
#else
  uint32_t mask = 0xff;
  MENISCUS_UNROLL
  for (uint32_t axis = 0; axis < 3; ++axis) {
    uint32_t begins = 0, ends = 0;
    MENISCUS_UNROLL
    for (uint32_t k = 0; k < 8; ++k) begins |= uint32_t{lower[axis][k] <= most[axis]} << k;
    MENISCUS_UNROLL
    for (uint32_t k = 0; k < 8; ++k) ends |= uint32_t{upper[axis][k] >= least[axis]} << k;
    mask &= begins & ends;
  }
  return mask;
#endif
}

}  // namespace meniscus::pbd
