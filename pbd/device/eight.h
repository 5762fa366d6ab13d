// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Comparisons of eight floats that lie side by side (aligned to 16 bytes) with one: bit k is float k's
// answer.
#pragma once

#include <cstdint>

#include "pbd/device/qualifiers.h"

#if defined(__SSE2__) && !defined(__CUDACC__)
#include <emmintrin.h>
#endif

namespace meniscus::pbd {

MENISCUS_HD inline uint32_t at_most_mask(const float* eight, float limit) {
#if defined(__SSE2__) && !defined(__CUDACC__)
  const __m128 b = _mm_set1_ps(limit);
  return static_cast<uint32_t>(_mm_movemask_ps(_mm_cmple_ps(_mm_load_ps(eight), b)) |
                               _mm_movemask_ps(_mm_cmple_ps(_mm_load_ps(eight + 4), b)) << 4);
#else
  uint32_t mask = 0;
  MENISCUS_UNROLL
  for (uint32_t k = 0; k < 8; ++k) mask |= uint32_t{eight[k] <= limit} << k;
  return mask;
#endif
}

MENISCUS_HD inline uint32_t at_least_mask(const float* eight, float limit) {
#if defined(__SSE2__) && !defined(__CUDACC__)
  const __m128 b = _mm_set1_ps(limit);
  return static_cast<uint32_t>(_mm_movemask_ps(_mm_cmpge_ps(_mm_load_ps(eight), b)) |
                               _mm_movemask_ps(_mm_cmpge_ps(_mm_load_ps(eight + 4), b)) << 4);
#else
  uint32_t mask = 0;
  MENISCUS_UNROLL
  for (uint32_t k = 0; k < 8; ++k) mask |= uint32_t{eight[k] >= limit} << k;
  return mask;
#endif
}

}  // namespace meniscus::pbd
