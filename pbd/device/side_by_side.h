// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "pbd/device/scalar.h"

namespace meniscus::pbd {

/// Items that are worked on side by side, one in each of D's lanes: `count` of them, from `first` on. Lanes
/// that are left over have the first one as well, and are to do nothing.
template <class D>
struct SideBySide {
  using Real = typename D::Real;

  Places<D> items;
  uint32_t count;

  /// Those of [0, end) from `first` on.
  MENISCUS_HD SideBySide(uint32_t first, uint32_t end)
      : count(D::lane_count == 1 || end - first < D::lane_count ? end - first : D::lane_count) {
    for (uint32_t lane = 0; lane < D::lane_count; ++lane) items.at[lane] = first + (lane < count ? lane : 0);
  }
  MENISCUS_HD auto index() const { return items.index(); }
  /// Bits of the lanes that are not left over.
  MENISCUS_HD uint32_t mask() const { return D::lane_count == 1 ? 1 : (1u << count) - 1; }
  /// x in those, 0 in others.
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
