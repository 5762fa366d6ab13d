// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Where no node touches air and nothing gives way, as in a vessel that is full to the brim, the equation has
// a solution only if there is nothing too much in all, and leaves the pressure's constant open. So what there
// is too much in all is taken from each node by its share, and the pressure is 0 where it is least.
#pragma once

#include "fluid/pressure_grid_faces_kernels.h"

namespace meniscus::fluid::grid_kernels {

struct Balance {
  double excess = 0, filled = 0;  ///< of all nodes: m³, and shares
  uint32_t open = 0;              ///< nodes from which there is a way out

  MENISCUS_HD bool closed() const { return open == 0 && filled > 0; }
  /// m³ a whole node
  MENISCUS_HD float surplus() const { return closed() ? static_cast<float>(excess / filled) : 0.0f; }
};

struct AddBalances {
  MENISCUS_HD Balance operator()(const Balance& a, const Balance& b) const {
    return {a.excess + b.excess, a.filled + b.filled, a.open + b.open};
  }
};

struct FindBalance {
  NodeTable nodes;
  View<const uint32_t> flags;
  View<const Coefficients> coefficients;
  View<const float> right, filled;

  MENISCUS_HD Balance operator()(uint32_t node) const {
    if (!(flags[node] & node_fluid)) return {};
    return {double{right[node]}, double{filled[node]}, is_open(node) ? 1u : 0u};
  }

  /// Whether a node's faces towards other fluid are not all that holds its pressure.
  MENISCUS_HD bool is_open(uint32_t node) const {
    const NodeCoordinates c = nodes.coordinates(node);
    const Coefficients own = coefficients[node];
    float within = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const uint32_t before = nodes.beside(c, axis, -1), after = nodes.beside(c, axis, 1);
      if (flags[before] & node_fluid) within += along(coefficients[before], axis);
      if (flags[after] & node_fluid) within += along(own, axis);
    }
    return own.w - within > 1e-6f * own.w;
  }
};

struct TakeSurplus {
  View<const uint32_t> flags;
  View<const float> filled;
  View<const Balance> balance;
  View<float> right;

  MENISCUS_HD void operator()(uint32_t node) const {
    if (flags[node] & node_fluid) right[node] -= balance[0].surplus() * filled[node];
  }
};

}  // namespace meniscus::fluid::grid_kernels
