// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The eight lanes of lanes.h in one AVX2 register, for processors that have it: the same operations in the
// same order, so the same bits. The program's baseline lacks AVX2. So each function here names its target,
// and its callers are inlined into a function with the same target (CpuDevice::run_wide).
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define MENISCUS_HAS_WIDE_LANES 1

#include <immintrin.h>

#include "pbd/device/cpu/lanes.h"

#define MENISCUS_WIDE_FN inline __attribute__((target("avx2")))

namespace meniscus::pbd {

/// It has copy functions of its own, so it is passed through memory where a call is not inlined, whatever the
/// targets of caller and callee.
struct WideLanes {
  static constexpr uint32_t count = 8;

  __m256 all;

  WideLanes() = default;
  MENISCUS_WIDE_FN WideLanes(const WideLanes& from) : all(from.all) {}
  MENISCUS_WIDE_FN WideLanes& operator=(const WideLanes& from) {
    all = from.all;
    return *this;
  }
  MENISCUS_WIDE_FN explicit WideLanes(const __m256& v) : all(v) {}
  MENISCUS_WIDE_FN WideLanes(float s) : all(_mm256_set1_ps(s)) {}
};

MENISCUS_WIDE_FN WideLanes operator+(const WideLanes& a, const WideLanes& b) {
  return WideLanes(_mm256_add_ps(a.all, b.all));
}
MENISCUS_WIDE_FN WideLanes operator-(const WideLanes& a, const WideLanes& b) {
  return WideLanes(_mm256_sub_ps(a.all, b.all));
}
MENISCUS_WIDE_FN WideLanes operator*(const WideLanes& a, const WideLanes& b) {
  return WideLanes(_mm256_mul_ps(a.all, b.all));
}
MENISCUS_WIDE_FN WideLanes operator/(const WideLanes& a, const WideLanes& b) {
  return WideLanes(_mm256_div_ps(a.all, b.all));
}
MENISCUS_WIDE_FN WideLanes operator-(const WideLanes& a) {
  return WideLanes(_mm256_xor_ps(a.all, _mm256_set1_ps(-0.0f)));
}
MENISCUS_WIDE_FN WideLanes& operator+=(WideLanes& a, const WideLanes& b) {
  return a = a + b;
}
MENISCUS_WIDE_FN WideLanes& operator*=(WideLanes& a, const WideLanes& b) {
  return a = a * b;
}

/// As for floats: b where a is NaN.
MENISCUS_WIDE_FN WideLanes max(const WideLanes& a, const WideLanes& b) {
  return WideLanes(_mm256_max_ps(a.all, b.all));
}
MENISCUS_WIDE_FN WideLanes unit_part(const WideLanes& a) {
  return max(a, WideLanes(0.0f));
}
MENISCUS_WIDE_FN WideLanes square_root(const WideLanes& a) {
  return WideLanes(_mm256_sqrt_ps(a.all));
}
MENISCUS_WIDE_FN WideLanes sine(const WideLanes& a) {
  alignas(32) float each[WideLanes::count];
  _mm256_store_ps(each, a.all);
  for (float& s : each) s = __builtin_sinf(s);
  return WideLanes(_mm256_load_ps(each));
}
MENISCUS_WIDE_FN WideLanes inverse_sqrt(const WideLanes& a) {
  return WideLanes(_mm256_div_ps(_mm256_set1_ps(1.0f), _mm256_sqrt_ps(a.all)));
}
MENISCUS_WIDE_FN WideLanes select_less(const WideLanes& x, const WideLanes& y, const WideLanes& a,
                                       const WideLanes& b) {
  return WideLanes(_mm256_blendv_ps(b.all, a.all, _mm256_cmp_ps(x.all, y.all, _CMP_LT_OQ)));
}
MENISCUS_WIDE_FN uint32_t less_mask(const WideLanes& a, const WideLanes& b) {
  return static_cast<uint32_t>(_mm256_movemask_ps(_mm256_cmp_ps(a.all, b.all, _CMP_LT_OQ)));
}

/// Uses the same tree as sum(Lanes).
MENISCUS_WIDE_FN float sum(const WideLanes& a) {
  const Float4 s = _mm_add_ps(_mm256_castps256_ps128(a.all), _mm256_extractf128_ps(a.all, 1));
  return (s[0] + s[2]) + (s[1] + s[3]);
}

/// The indices of eight neighbours, adjacent in a row of the list.
struct WideIndex {
  const uint32_t* at;

  uint32_t operator[](int lane) const { return at[lane]; }
};

namespace detail {

/// The four words of a and of b, side by side.
template <class T>
MENISCUS_WIDE_FN __m256 load_two(const T& a, const T& b) {
  static_assert(sizeof(T) == sizeof(__m128) && alignof(T) == alignof(__m128));
  return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_load_ps(reinterpret_cast<const float*>(&a))),
                              _mm_load_ps(reinterpret_cast<const float*>(&b)), 1);
}

MENISCUS_WIDE_FN Vec4Of<WideLanes> transpose(const __m256& a, const __m256& b, const __m256& c,
                                             const __m256& d) {
  const __m256 ab_low = _mm256_unpacklo_ps(a, b), ab_high = _mm256_unpackhi_ps(a, b);
  const __m256 cd_low = _mm256_unpacklo_ps(c, d), cd_high = _mm256_unpackhi_ps(c, d);
  return {WideLanes(_mm256_shuffle_ps(ab_low, cd_low, 0x44)),
          WideLanes(_mm256_shuffle_ps(ab_low, cd_low, 0xee)),
          WideLanes(_mm256_shuffle_ps(ab_high, cd_high, 0x44)),
          WideLanes(_mm256_shuffle_ps(ab_high, cd_high, 0xee))};
}

}  // namespace detail

template <class T>
MENISCUS_WIDE_FN Vec4Of<WideLanes> gather_words(const View<const T>& from, const WideIndex& j) {
  using detail::load_two;
  return detail::transpose(load_two(from[j[0]], from[j[4]]), load_two(from[j[1]], from[j[5]]),
                           load_two(from[j[2]], from[j[6]]), load_two(from[j[3]], from[j[7]]));
}
MENISCUS_WIDE_FN Vec4Of<WideLanes> gather(const View<const Vec4>& from, const WideIndex& j) {
  return gather_words(from, j);
}
/// Rows k and k + 4 side by side.
struct WideRows {
  __m256 two[4];

  MENISCUS_WIDE_FN __m128 operator[](int k) const {
    return k < 4 ? _mm256_castps256_ps128(two[k]) : _mm256_extractf128_ps(two[k - 4], 1);
  }
};

MENISCUS_WIDE_FN WideRows rows(const Vec4Of<WideLanes>& v) {
  const Vec4Of<WideLanes> each = detail::transpose(v.x.all, v.y.all, v.z.all, v.w.all);
  return {{each.x.all, each.y.all, each.z.all, each.w.all}};
}
MENISCUS_WIDE_FN void scatter(const View<Vec4>& to, const WideIndex& j, const Vec4Of<WideLanes>& v,
                              uint32_t mask) {
  const WideRows r = rows(v);
  for (int k = 0; k < 8; ++k)
    if (mask >> k & 1) _mm_store_ps(&to[j[k]].x, r[k]);
}
MENISCUS_WIDE_FN void add(const View<Vec4>& to, const WideIndex& j, const WideRows& r) {
  for (int k = 0; k < 8; ++k) {
    float* const at = &to[j[k]].x;
    _mm_store_ps(at, _mm_add_ps(_mm_load_ps(at), r[k]));
  }
}
MENISCUS_WIDE_FN WideLanes gather(const View<const float>& from, const WideIndex& j) {
  return WideLanes(_mm256_setr_ps(from[j[0]], from[j[1]], from[j[2]], from[j[3]], from[j[4]], from[j[5]],
                                  from[j[6]], from[j[7]]));
}

/// See LaneLister.
struct WideLister {
  MENISCUS_WIDE_FN static uint32_t near(const View<const Vec4>& position, const Vec3& self, float reach2,
                                        uint32_t first, uint32_t count) {
    using detail::load_two;
    uint32_t mask = 0;
    for (uint32_t k = 0; k < count; k += WideLanes::count) {
      const Vec4* p = &position[first + k];
      const Vec4Of<WideLanes> other = detail::transpose(load_two(p[0], p[4]), load_two(p[1], p[5]),
                                                        load_two(p[2], p[6]), load_two(p[3], p[7]));
      const Vec3Of<WideLanes> d = self - other.xyz();
      mask |= less_mask(dot(d, d), WideLanes(reach2)) << k;
    }
    return count < 32 ? mask & ((1u << count) - 1) : mask;
  }
};

/// The device type of kernels where the processor has AVX2; see CpuDevice.
struct CpuWide {
  using Real = WideLanes;
  using LaneIndex = WideIndex;
  static constexpr uint32_t lane_count = WideLanes::count;
  static constexpr bool interleaves_lists = false;
  using Lister = WideLister;
  static bool leads() { return true; }
};

}  // namespace meniscus::pbd

#endif
