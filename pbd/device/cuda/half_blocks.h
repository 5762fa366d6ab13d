// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Points in 16-bit floats. A GPU processes two with each instruction, and loads four at once.
#pragma once

#include <cstdint>

#include "pbd/device/base/view.h"
#include "pbd/math/vec.h"

#ifdef __CUDA_ARCH__
#include <cuda_fp16.h>
#endif

namespace meniscus::pbd {

struct alignas(8) HalfBlock {
  static constexpr uint32_t points = 4;

  uint16_t x[points], y[points], z[points];
};

MENISCUS_HD inline uint16_t half_of(float value) {
#ifdef __CUDA_ARCH__
  return __half_as_ushort(__float2half_rn(value));
#else
  return static_cast<uint16_t>(value);  // no CPU reads them
#endif
}

/// Finds the points nearer than 1 to a centre, where x is periodic.
class NearHalves {
 public:
#ifdef __CUDA_ARCH__
  __device__ NearHalves(float x, float period)
      : x_(__float2half2_rn(x)), period_(__float2half2_rn(period)), limit_(__float2half2_rn(1.0f)) {}
  /// Sets the centre relative to the points that follow.
  __device__ void set_row(float y, float z) {
    y_ = __float2half2_rn(y);
    z_ = __float2half2_rn(z);
  }

  /// Calls visit(j, k) for each point j + k from `begin` to `end` that is near. Reads up to two blocks beyond
  /// the end.
  template <class Visit>
  __device__ void for_each(View<const HalfBlock> blocks, uint32_t begin, uint32_t end,
                           const Visit& visit) const {
    if (begin >= end) return;
    const HalfBlock* at = blocks.data + begin / HalfBlock::points;
    uint32_t j = begin - begin % HalfBlock::points;
    Loaded even(at);
    even.hide_first(begin - j);
    MENISCUS_NO_UNROLL
    for (;;) {  // alternating, so that no values are moved between registers
      const Loaded odd(at + 1);
      look(even, j, end, visit);
      if ((j += HalfBlock::points) >= end) break;
      even = Loaded(at += 2);
      look(odd, j, end, visit);
      if ((j += HalfBlock::points) >= end) break;
    }
  }

 private:
  struct Loaded {
    uint2 x, y, z;

    __device__ explicit Loaded(const HalfBlock* block)
        : x(__ldg(reinterpret_cast<const uint2*>(block->x))),
          y(__ldg(reinterpret_cast<const uint2*>(block->y))),
          z(__ldg(reinterpret_cast<const uint2*>(block->z))) {}
    /// Makes the first n points, fewer than four, infinitely far.
    __device__ void hide_first(uint32_t n) {
      constexpr uint64_t not_finite = 0x7c00'7c00'7c00'7c00;
      const uint64_t hidden = not_finite & ((uint64_t{1} << 16 * n) - 1);
      z.x |= static_cast<uint32_t>(hidden);
      z.y |= static_cast<uint32_t>(hidden >> 32);
    }
  };

  template <class Visit>
  __device__ void look(const Loaded& block, uint32_t j, uint32_t end, const Visit& visit) const {
    bool near[HalfBlock::points];
    look_at_two(block.x.x, block.y.x, block.z.x, near);
    look_at_two(block.x.y, block.y.y, block.z.y, near + 2);
    MENISCUS_UNROLL
    for (int k = 0; k < static_cast<int>(HalfBlock::points); ++k)
      if (near[k] && static_cast<int>(j) < static_cast<int>(end) - k) visit(j, static_cast<uint32_t>(k));
  }

  /// The result is the same for both orders of a pair.
  __device__ void look_at_two(uint32_t x, uint32_t y, uint32_t z, bool* near) const {
    const __half2 displacement = __habs2(__hsub2(halves(x), x_)),
                  dx = __hmin2(displacement, __hsub2(period_, displacement));
    const __half2 dy = __hsub2(halves(y), y_), dz = __hsub2(halves(z), z_);
    const __half2 d2 = __hfma2(dx, dx, __hfma2(dy, dy, __hmul2(dz, dz)));
    uint32_t first, second;
    asm("{ .reg .pred p, q;\n setp.lt.f16x2 p|q, %2, %3;\n selp.u32 %0, 1, 0, p;\n selp.u32 %1, 1, 0, q; }"
        : "=r"(first), "=r"(second)
        : "r"(word(d2)), "r"(word(limit_)));
    near[0] = first != 0;
    near[1] = second != 0;
  }

  __device__ static __half2 halves(uint32_t word) {
    __half2 value;
    __builtin_memcpy(&value, &word, sizeof value);
    return value;
  }
  __device__ static uint32_t word(__half2 halves) {
    uint32_t value;
    __builtin_memcpy(&value, &halves, sizeof value);
    return value;
  }

  __half2 x_, y_, z_, period_, limit_;
#else
  MENISCUS_HD NearHalves(float, float) {}
  MENISCUS_HD void set_row(float, float) {}
  template <class Visit>
  MENISCUS_HD void for_each(View<const HalfBlock>, uint32_t, uint32_t, const Visit&) const {}
#endif
};

}  // namespace meniscus::pbd
