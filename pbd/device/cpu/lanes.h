// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Eight float lanes. The number is the same for every instruction set, and sums use a fixed tree, so that
// every processor gives the same bits. Two halves of four fit the baseline of x86-64 and of ARM.
#pragma once

#include <cstdint>
#include <cstring>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "pbd/device/base/view.h"
#include "pbd/math/vec.h"

#define MENISCUS_LANE_FN inline __attribute__((always_inline))

namespace meniscus::pbd {

using Float4 = float __attribute__((vector_size(16)));

struct Lanes {
  static constexpr uint32_t count = 8;

  Float4 low, high;

  Lanes() = default;
  MENISCUS_LANE_FN Lanes(Float4 a, Float4 b) : low(a), high(b) {}
  MENISCUS_LANE_FN Lanes(float s) : low{s, s, s, s}, high{s, s, s, s} {}
};

MENISCUS_LANE_FN Lanes operator+(Lanes a, Lanes b) {
  return {a.low + b.low, a.high + b.high};
}
MENISCUS_LANE_FN Lanes operator-(Lanes a, Lanes b) {
  return {a.low - b.low, a.high - b.high};
}
MENISCUS_LANE_FN Lanes operator*(Lanes a, Lanes b) {
  return {a.low * b.low, a.high * b.high};
}
MENISCUS_LANE_FN Lanes operator/(Lanes a, Lanes b) {
  return {a.low / b.low, a.high / b.high};
}
MENISCUS_LANE_FN Lanes operator-(Lanes a) {
  return {-a.low, -a.high};
}
MENISCUS_LANE_FN Lanes& operator+=(Lanes& a, Lanes b) {
  return a = a + b;
}
MENISCUS_LANE_FN Lanes& operator*=(Lanes& a, Lanes b) {
  return a = a * b;
}

MENISCUS_LANE_FN Lanes max(Lanes a, Lanes b) {
  return {a.low > b.low ? a.low : b.low, a.high > b.high ? a.high : b.high};
}

MENISCUS_LANE_FN Float4 square_root(Float4 a) {
  Float4 r;
  for (int k = 0; k < 4; ++k) r[k] = __builtin_sqrtf(a[k]);
  return r;
}

MENISCUS_LANE_FN Lanes square_root(Lanes a) {
  return {square_root(a.low), square_root(a.high)};
}
MENISCUS_LANE_FN Float4 sine(Float4 a) {
  Float4 r;
  for (int k = 0; k < 4; ++k) r[k] = __builtin_sinf(a[k]);
  return r;
}
MENISCUS_LANE_FN Lanes sine(Lanes a) {
  return {sine(a.low), sine(a.high)};
}
/// See scalar.h.
MENISCUS_LANE_FN Lanes unit_part(Lanes a) {
  return max(a, Lanes(0.0f));
}
/// 1/√a for a > 0. Both operations are correctly rounded, unlike rsqrtps, whose bits differ between
/// manufacturers.
MENISCUS_LANE_FN Lanes inverse_sqrt(Lanes a) {
  return Lanes(1.0f) / square_root(a);
}

/// a where x < y, else b, lane by lane.
MENISCUS_LANE_FN Lanes select_less(Lanes x, Lanes y, Lanes a, Lanes b) {
  return {x.low < y.low ? a.low : b.low, x.high < y.high ? a.high : b.high};
}

/// Bit k is set where a < b in lane k.
MENISCUS_LANE_FN uint32_t less_mask(Lanes a, Lanes b) {
#ifdef __SSE2__
  return static_cast<uint32_t>(_mm_movemask_ps(reinterpret_cast<__m128>(a.low < b.low)) |
                               _mm_movemask_ps(reinterpret_cast<__m128>(a.high < b.high)) << 4);
#else
  uint32_t mask = 0;
  for (int k = 0; k < 4; ++k)
    mask |= uint32_t(a.low[k] < b.low[k]) << k | uint32_t(a.high[k] < b.high[k]) << (k + 4);
  return mask;
#endif
}

/// The sum over the lanes, by halves: a fixed tree.
MENISCUS_LANE_FN float sum(Lanes a) {
  const Float4 s = a.low + a.high;
  return (s[0] + s[2]) + (s[1] + s[3]);
}

namespace detail {

struct Transposed {
  Float4 x, y, z, w;
};

/// The four words of v.
template <class T>
MENISCUS_LANE_FN Float4 load4(const T& v) {
  static_assert(sizeof(T) == sizeof(Float4));
  Float4 r;
  std::memcpy(&r, &v, sizeof r);
  return r;
}

MENISCUS_LANE_FN Transposed transpose(Float4 a, Float4 b, Float4 c, Float4 d) {
  const Float4 ab_low = __builtin_shufflevector(a, b, 0, 4, 1, 5),
               ab_high = __builtin_shufflevector(a, b, 2, 6, 3, 7);
  const Float4 cd_low = __builtin_shufflevector(c, d, 0, 4, 1, 5),
               cd_high = __builtin_shufflevector(c, d, 2, 6, 3, 7);
  return {__builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5),
          __builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7),
          __builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5),
          __builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7)};
}

MENISCUS_LANE_FN Vec4Of<Lanes> join(const Transposed& a, const Transposed& b) {
  return {{a.x, b.x}, {a.y, b.y}, {a.z, b.z}, {a.w, b.w}};
}

}  // namespace detail

/// The indices of eight neighbours, adjacent in a row of the list.
struct LaneIndex {
  const uint32_t* at;

  MENISCUS_LANE_FN uint32_t operator[](int lane) const { return at[lane]; }
};

/// Elements of four words each, word by word.
template <class T>
MENISCUS_LANE_FN Vec4Of<Lanes> gather_words(View<const T> from, LaneIndex j) {
  using detail::load4;
  return detail::join(
      detail::transpose(load4(from[j[0]]), load4(from[j[1]]), load4(from[j[2]]), load4(from[j[3]])),
      detail::transpose(load4(from[j[4]]), load4(from[j[5]]), load4(from[j[6]]), load4(from[j[7]])));
}
MENISCUS_LANE_FN Vec4Of<Lanes> gather(View<const Vec4> from, LaneIndex j) {
  return gather_words(from, j);
}

/// The contents of eight lanes, lane by lane.
struct LaneRows {
  Float4 each[8];
};

MENISCUS_LANE_FN LaneRows rows(const Vec4Of<Lanes>& v) {
  const detail::Transposed low = detail::transpose(v.x.low, v.y.low, v.z.low, v.w.low),
                           high = detail::transpose(v.x.high, v.y.high, v.z.high, v.w.high);
  return {{low.x, low.y, low.z, low.w, high.x, high.y, high.z, high.w}};
}
/// Lane k goes to to[j[k]] where bit k of the mask is set.
MENISCUS_LANE_FN void scatter(View<Vec4> to, LaneIndex j, const Vec4Of<Lanes>& v, uint32_t mask) {
  const LaneRows r = rows(v);
  for (int k = 0; k < 8; ++k)
    if (mask >> k & 1) std::memcpy(&to[j[k]], &r.each[k], sizeof(Float4));
}
/// Row k is added to to[j[k]], one after the other.
MENISCUS_LANE_FN void add(View<Vec4> to, LaneIndex j, const LaneRows& r) {
  for (int k = 0; k < 8; ++k) {
    const Float4 sum = detail::load4(to[j[k]]) + r.each[k];
    std::memcpy(&to[j[k]], &sum, sizeof sum);
  }
}

MENISCUS_LANE_FN Lanes gather(View<const float> from, LaneIndex j) {
  return {Float4{from[j[0]], from[j[1]], from[j[2]], from[j[3]]},
          Float4{from[j[4]], from[j[5]], from[j[6]], from[j[7]]}};
}

/// Eight consecutive elements from `first` on; the array must reach that far.
MENISCUS_LANE_FN Vec4Of<Lanes> load_run(View<const Vec4> from, uint32_t first, Lanes*) {
  using detail::load4;
  const Vec4* p = &from[first];
  return detail::join(detail::transpose(load4(p[0]), load4(p[1]), load4(p[2]), load4(p[3])),
                      detail::transpose(load4(p[4]), load4(p[5]), load4(p[6]), load4(p[7])));
}

/// The CPU's counterpart of CudaLister.
struct LaneLister {
  MENISCUS_LANE_FN static uint32_t near(View<const Vec4> position, Vec3 self, float reach2, uint32_t first,
                                        uint32_t count) {
    uint32_t mask = 0;
    for (uint32_t k = 0; k < count; k += Lanes::count) {
      const Vec3Of<Lanes> d = self - load_run(position, first + k, static_cast<Lanes*>(nullptr)).xyz();
      mask |= less_mask(dot(d, d), Lanes(reach2)) << k;
    }
    return count < 32 ? mask & ((1u << count) - 1) : mask;
  }
};

}  // namespace meniscus::pbd
