// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// How a thread of the GPU looks through candidates for neighbours: so many loads are on their way before the
// first is used. More of them take registers, and with them other threads: they pay where there are few.
#pragma once

#include <cstdint>

#include "pbd/device/view.h"
#include "pbd/math/vec.h"

namespace meniscus::pbd {

template <uint32_t batch>
struct CudaLister {
  /// Bit k is set where particle first + k is nearer to `self` than the root of reach2; count ≤ 32. The array
  /// must reach batch − 1 elements further.
  MENISCUS_HD static uint32_t near(View<const Vec4> position, Vec3 self, float reach2, uint32_t first,
                                   uint32_t count) {
    const View<const Vec4> run{position.data + first, position.count - first};
    uint32_t mask = 0, seen = 0;  // the first one's bit goes up as others come in
    for (; seen < count; seen += batch) {
      Vec4 candidate[batch];
      MENISCUS_UNROLL
      for (uint32_t k = 0; k < batch; ++k) candidate[k] = load(run, seen + k);
      MENISCUS_UNROLL
      for (uint32_t k = 0; k < batch; ++k) {
        const Vec3 d = self - candidate[k].xyz();
        mask = with_sign(mask, d.x * d.x + (d.y * d.y + (d.z * d.z - reach2)));
      }
    }
    if (count == 0) return 0;
    return reversed(mask << (32 - seen)) & (0xffffffffu >> (32 - count));
  }

 private:
  MENISCUS_HD static uint32_t with_sign(uint32_t mask, float x) {
#ifdef __CUDA_ARCH__
    return __funnelshift_l(__float_as_uint(x), mask, 1);
#else
    return mask << 1 | uint32_t(x < 0);
#endif
  }
  MENISCUS_HD static uint32_t reversed(uint32_t mask) {
#ifdef __CUDA_ARCH__
    return __brev(mask);
#else
    uint32_t out = 0;
    for (uint32_t k = 0; k < 32; ++k) out |= (mask >> k & 1) << (31 - k);
    return out;
#endif
  }
};

}  // namespace meniscus::pbd
