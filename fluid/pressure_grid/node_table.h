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

  MENISCUS_HD uint32_t count() const { return 1u << (bits[0] + bits[1] + bits[2]); }

  MENISCUS_HD NodeCoordinates coordinates(uint32_t node) const {
    const auto low = [](uint32_t v, uint32_t n) { return static_cast<int32_t>(v & ((1u << n) - 1)); };
    return {{low(node, bits[0]), low(node >> bits[0], bits[1]), low(node >> (bits[0] + bits[1]), bits[2])}};
  }

  MENISCUS_HD uint32_t index(int32_t x, int32_t y, int32_t z) const {
    const auto wrap = [](int32_t v, uint32_t n) { return static_cast<uint32_t>(v) & ((1u << n) - 1); };
    return wrap(x, bits[0]) | wrap(y, bits[1]) << bits[0] | wrap(z, bits[2]) << (bits[0] + bits[1]);
  }
  MENISCUS_HD uint32_t index(const NodeCoordinates& c) const { return index(c.at[0], c.at[1], c.at[2]); }

  /// The node `step` away from c along an axis.
  MENISCUS_HD uint32_t beside(NodeCoordinates c, int axis, int32_t step) const {
    c.at[axis] += step;
    return index(c);
  }
};

}  // namespace meniscus::fluid
