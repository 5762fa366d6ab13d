// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The one-lane forms of the functions that device/cpu/lanes.h has for eight lanes, so that kernels read the
// same over either.
#pragma once

#include <cmath>
#include <cstdint>

#include "pbd/device/base/view.h"
#include "pbd/math/vec.h"

namespace meniscus::pbd {

/// The greatest value that counts as finite.
inline constexpr float most_finite = 3e38f;

MENISCUS_HD inline float sum(float a) {
  return a;
}
MENISCUS_HD inline uint32_t less_mask(float a, float b) {
  return a < b;
}
MENISCUS_HD inline float select_less(float x, float y, float a, float b) {
  return x < y ? a : b;
}

/// The sum, or the limit if the sum is greater. It is associative, as there are no negative numbers.
struct SumUpTo {
  uint32_t limit;

  MENISCUS_HD uint32_t operator()(uint32_t a, uint32_t b) const {
    return b < limit && a < limit - b ? a + b : limit;
  }
};

/// A record of sums: the last one and the greatest.
struct SumNote {
  uint32_t last, most;

  MENISCUS_HD void take(uint32_t sum) {
    last = sum;
    if (most < sum) most = sum;
  }
};

MENISCUS_HD inline float square_root(float a) {
  return sqrtf(a);
}
MENISCUS_HD inline float sine(float a) {
  return sinf(a);
}
/// a b + c. A GPU's compiler may round once or twice, and differently in two kernels. This is always rounded
/// once on a GPU.
MENISCUS_HD inline float multiply_add(float a, float b, float c) {
#ifdef __CUDA_ARCH__
  return __fmaf_rn(a, b, c);
#else
  return a * b + c;
#endif
}
/// For a > 0. On a GPU the result for a denormal float is ∞; a check would take three instructions.
MENISCUS_HD inline float inverse_sqrt(float a) {
#ifdef __CUDA_ARCH__
  float root;
  asm("rsqrt.approx.ftz.f32 %0, %1;" : "=f"(root) : "f"(a));
  return root;
#else
  return 1.0f / sqrtf(a);
#endif
}

/// √a, accurate to a few units in the last place on a GPU: for bounds with a margin for that.
MENISCUS_HD inline float quick_root(float a) {
#ifdef __CUDA_ARCH__
  float root;
  asm("sqrt.approx.ftz.f32 %0, %1;" : "=f"(root) : "f"(a));
  return root;
#else
  return sqrtf(a);
#endif
}

/// max(a, 0) for a ≤ 1; 0 for NaN. On a GPU it is a modifier of the previous instruction.
MENISCUS_HD inline float unit_part(float a) {
#ifdef __CUDA_ARCH__
  return __saturatef(a);
#else
  return a > 0 ? a : 0.0f;
#endif
}

/// The lowest set bit's place; mask must not be 0.
MENISCUS_HD inline uint32_t lowest_bit(uint32_t mask) {
#ifdef __CUDA_ARCH__
  return static_cast<uint32_t>(__ffs(static_cast<int>(mask)) - 1);
#else
  return static_cast<uint32_t>(__builtin_ctz(mask));
#endif
}

MENISCUS_HD inline uint32_t bit_count(uint32_t mask) {
#ifdef __CUDA_ARCH__
  return static_cast<uint32_t>(__popc(mask));
#else
  return static_cast<uint32_t>(__builtin_popcount(mask));
#endif
}

/// Indices, one for each lane, as gather() and scatter() take them.
template <class D>
struct Places {
  uint32_t at[D::lane_count];

  MENISCUS_HD auto index() const {
    if constexpr (D::lane_count == 1) {
      return at[0];
    } else {
      return typename D::LaneIndex{at};
    }
  }
};

/// A number with value(lane) in each lane.
template <class D, class Value>
MENISCUS_HD typename D::Real by_lane(const Value& value) {
  if constexpr (D::lane_count == 1) {
    return value(0);
  } else {
    float each[D::lane_count];
    Places<D> order;
    for (uint32_t lane = 0; lane < D::lane_count; ++lane) {
      each[lane] = value(lane);
      order.at[lane] = lane;
    }
    return gather(View<const float>{each, D::lane_count}, order.index());
  }
}

template <class T>
MENISCUS_HD Vec4Of<float> gather_words(View<const T> from, uint32_t j) {
  const T v = load(from, j);
  Vec4Of<float> words;
  static_assert(sizeof v == sizeof words);
  __builtin_memcpy(&words, &v, sizeof v);
  return words;
}
MENISCUS_HD inline Vec4Of<float> gather(View<const Vec4> from, uint32_t j) {
  return gather_words(from, j);
}
/// For an array that the kernel also writes.
MENISCUS_HD inline Vec4Of<float> gather(View<Vec4> from, uint32_t j) {
  const Vec4 v = from[j];
  return {v.x, v.y, v.z, v.w};
}
MENISCUS_HD inline void scatter(View<Vec4> to, uint32_t j, const Vec4Of<float>& v, uint32_t mask) {
  if (mask & 1) to[j] = {v.x, v.y, v.z, v.w};
}
MENISCUS_HD inline float gather(View<const float> from, uint32_t j) {
  return from[j];
}

template <class R>
MENISCUS_HD Vec3 sum(const Vec3Of<R>& a) {
  return {sum(a.x), sum(a.y), sum(a.z)};
}

}  // namespace meniscus::pbd
