// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Items that a kernel processes together, one in each SIMD lane.
#pragma once

#include "pbd/device/scalar.h"

namespace meniscus::pbd {

/// Items that are processed side by side, one in each of D's lanes: `count` items from `first` on. Unused
/// lanes hold the first item as well, and must have no effect.
template <class D>
struct SideBySide {
  using Real = typename D::Real;

  Places<D> items;
  uint32_t count;

  /// The items of [0, end) from `first` on.
  MENISCUS_HD SideBySide(uint32_t first, uint32_t end)
      : count(D::lane_count == 1 || end - first < D::lane_count ? end - first : D::lane_count) {
    for (uint32_t lane = 0; lane < D::lane_count; ++lane) items.at[lane] = first + (lane < count ? lane : 0);
  }
  MENISCUS_HD auto index() const { return items.index(); }
  /// The mask of the used lanes.
  MENISCUS_HD uint32_t mask() const { return D::lane_count == 1 ? 1 : (1u << count) - 1; }
  /// x in the used lanes, 0 in the others.
  MENISCUS_HD Real if_any(const Real& x) const {
    if constexpr (D::lane_count == 1) {
      return x;
    } else {
      const Real lanes = by_lane<D>([](uint32_t lane) { return static_cast<float>(lane); });
      return select_less(lanes, Real(static_cast<float>(count)), x, Real(0));
    }
  }
};

}  // namespace meniscus::pbd
