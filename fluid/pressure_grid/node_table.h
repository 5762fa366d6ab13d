// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Nodes of a grid without bounds, in a table that wraps around on each axis like that of the particles' cells
// (pbd/grid.h).
#pragma once

#include <cstdint>

#include "pbd/device/base/qualifiers.h"

namespace meniscus::fluid {

struct NodeCoordinates {
  int32_t at[3];
};

struct NodeTable {
  uint32_t bits[3] = {0, 0, 0};  ///< 2^bits nodes on each axis
  uint32_t strip_bits = 0;       ///< at most bits[1]: see pbd::GridView, whose cells have the same order

  MENISCUS_HD uint32_t count() const { return 1u << (bits[0] + bits[1] + bits[2]); }

  MENISCUS_HD NodeCoordinates coordinates(uint32_t node) const {
    const uint32_t row = node >> bits[0], row_layer = row >> strip_bits, strip = row_layer >> bits[2];
    const auto low = [](uint32_t v, uint32_t n) { return static_cast<int32_t>(v & ((1u << n) - 1)); };
    return {{low(node, bits[0]), static_cast<int32_t>(strip << strip_bits) | low(row, strip_bits),
             low(row_layer, bits[2])}};
  }

  MENISCUS_HD uint32_t index(int32_t x, int32_t y, int32_t z) const {
    const auto low = [](uint32_t v, uint32_t n) { return v & ((1u << n) - 1); };
    const auto wrap = [&](int32_t v, uint32_t n) { return low(static_cast<uint32_t>(v), n); };
    const uint32_t row = wrap(y, bits[1]);
    const uint32_t row_layer = row >> strip_bits << bits[2] | wrap(z, bits[2]);
    return (row_layer << strip_bits | low(row, strip_bits)) << bits[0] | wrap(x, bits[0]);
  }
  MENISCUS_HD uint32_t index(const NodeCoordinates& c) const { return index(c.at[0], c.at[1], c.at[2]); }

  /// The node `step` away from c along an axis.
  MENISCUS_HD uint32_t beside(NodeCoordinates c, int axis, int32_t step) const {
    c.at[axis] += step;
    return index(c);
  }
};

}  // namespace meniscus::fluid
