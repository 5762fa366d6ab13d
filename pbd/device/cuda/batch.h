// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// How a GPU thread tests candidates for neighbours: a batch of loads is in flight before the first is used.
// Larger batches take more registers, so fewer threads are resident. They pay off where threads are few.
#pragma once

#include <cstdint>

#include "pbd/device/base/view.h"
#include "pbd/math/vec.h"

namespace meniscus::pbd {

template <uint32_t batch>
struct CudaLister {
  /// Calls visit(j, position) for particles from `begin` to `end`, and for up to batch − 1 beyond. The array
  /// must extend that far.
  template <class Visit>
  MENISCUS_HD static void for_each(View<const Vec4> position, uint32_t begin, uint32_t end,
                                   const Visit& visit) {
    View<const Vec4> at{position.data + begin, batch};
    MENISCUS_NO_UNROLL
    for (uint32_t j = begin; j < end; j += batch, at.data += batch) {
      Vec4 candidate[batch];
      MENISCUS_UNROLL
      for (uint32_t k = 0; k < batch; ++k) candidate[k] = load(at, k);
      MENISCUS_UNROLL
      for (uint32_t k = 0; k < batch; ++k) visit(j + k, candidate[k].xyz());
    }
  }

  /// Bit k is set where particle first + k is nearer to `self` than the root of reach2; count ≤ 32. The array
  /// must extend batch − 1 elements further.
  MENISCUS_HD static uint32_t near(View<const Vec4> position, Vec3 self, float reach2, uint32_t first,
                                   uint32_t count) {
    View<const Vec4> at{position.data + first, batch};
    uint32_t mask = 0;
    MENISCUS_NO_UNROLL
    for (uint32_t seen = 0; seen < count; seen += batch, at.data += batch) {
      Vec4 candidate[batch];
      MENISCUS_UNROLL
      for (uint32_t k = 0; k < batch; ++k) candidate[k] = load(at, k);
      uint32_t near = 0;
      MENISCUS_UNROLL
      for (uint32_t k = 0; k < batch; ++k) {
        const Vec3 d = self - candidate[k].xyz();
        near |= static_cast<uint32_t>(dot(d, d) < reach2) << k;
      }
      mask |= near << seen;
    }
    return count < 32 ? mask & ((1u << count) - 1) : mask;
  }
};

}  // namespace meniscus::pbd
