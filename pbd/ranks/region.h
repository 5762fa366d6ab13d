// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The part of a shared world that belongs to one rank.
#pragma once

#include <cstdint>

#include "pbd/device/base/qualifiers.h"

namespace meniscus::pbd {

/// A rectangle of columns. A column is all cells with these y and z. The layers [first, end) of each axis are
/// in it. By default all columns are.
struct Region {
  /// Outside of all layers that a grid has.
  static constexpr int32_t unbounded = int32_t{1} << 30;

  int32_t first_y = -unbounded, end_y = unbounded, first_z = -unbounded, end_z = unbounded;

  MENISCUS_HD bool contains(int32_t y, int32_t z) const {
    return static_cast<uint32_t>(y) - static_cast<uint32_t>(first_y) < layers_y() &&
           static_cast<uint32_t>(z) - static_cast<uint32_t>(first_z) < layers_z();
  }
  /// Whether it contains the column or one of the eight beside it.
  MENISCUS_HD bool is_near(int32_t y, int32_t z) const { return grown(1).contains(y, z); }
  /// Whether it contains the column and the eight beside it.
  MENISCUS_HD bool is_inside(int32_t y, int32_t z) const { return grown(-1).contains(y, z); }
  /// With so many more layers on each side.
  MENISCUS_HD Region grown(int32_t layers) const {
    return {first_y - layers, end_y + layers, first_z - layers, end_z + layers};
  }

  // On each axis: the number of layers, and whether it ends there.
  MENISCUS_HD uint32_t layers_y() const {
    return static_cast<uint32_t>(end_y) - static_cast<uint32_t>(first_y);
  }
  MENISCUS_HD uint32_t layers_z() const {
    return static_cast<uint32_t>(end_z) - static_cast<uint32_t>(first_z);
  }
  MENISCUS_HD bool is_cut_along_y() const { return first_y != -unbounded || end_y != unbounded; }
  MENISCUS_HD bool is_cut_along_z() const { return first_z != -unbounded || end_z != unbounded; }
};

}  // namespace meniscus::pbd
