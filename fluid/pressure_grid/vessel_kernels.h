// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of vessels.h. Nodes that open faces join are one body of fluid, which is named by
// the greatest of its nodes.
#pragma once

#include <cstring>

#include "fluid/pressure_grid/faces_kernels.h"
#include "pbd/union_find.h"

namespace meniscus::fluid::grid_kernels {

/// What is known of a body of fluid, at the node that names it. Sums run in integers, which add up to the
/// same in any order.
struct VesselSums {
  int64_t excess;  ///< in particles' volumes / `unit`
  int64_t filled;  ///< in nodes' volumes / `unit`
  uint32_t open;   ///< 1 where there is a way out
  uint32_t least;  ///< the key of the least pressure

  static constexpr float unit = 1 << 20;
};

/// Greater for lesser pressures; never 0.
MENISCUS_HD inline uint32_t key_of(float pressure) {
  uint32_t bits;
  memcpy(&bits, &pressure, sizeof bits);
  return ~(bits >> 31 ? ~bits : bits | 0x80000000u);
}
MENISCUS_HD inline float pressure_of(uint32_t key) {
  const uint32_t ordered = ~key, bits = ordered >> 31 ? ordered & 0x7fffffffu : ~ordered;
  float pressure;
  memcpy(&pressure, &bits, sizeof pressure);
  return pressure;
}

struct Vessels {
  NodeTable nodes;
  View<const uint32_t> flags;
  View<const Coefficients> coefficients;
  View<uint32_t> label;
  View<VesselSums> sums;

  MENISCUS_HD bool is_fluid(uint32_t node) const { return (flags[node] & node_fluid) != 0; }

  MENISCUS_HD bool are_joined(uint32_t node, int axis, uint32_t after) const {
    return is_fluid(node) && along(coefficients[node], axis) > 0 && is_fluid(after);
  }

  MENISCUS_HD uint32_t name(uint32_t node) const { return pbd::UnionFind{label}.name(node); }
  MENISCUS_HD void unite(uint32_t a, uint32_t b) const { pbd::UnionFind{label}.unite(a, b); }
};

struct StartVessels {
  Vessels vessels;

  MENISCUS_HD void operator()(uint32_t node) const {
    vessels.label[node] = first_above(node);
    vessels.sums[node] = {0, 0, 0, 0};
  }

  /// Most nodes are united by this already. The table wraps around, so what comes after may be below.
  MENISCUS_HD uint32_t first_above(uint32_t node) const {
    const NodeCoordinates c = vessels.nodes.coordinates(node);
    for (int axis = 0; axis < 3; ++axis) {
      const uint32_t after = vessels.nodes.beside(c, axis, 1);
      if (after > node && vessels.are_joined(node, axis, after)) return after;
    }
    return node;
  }
};

struct UniteNodes {
  Vessels vessels;

  MENISCUS_HD void operator()(uint32_t node) const {
    if (!vessels.is_fluid(node)) return;
    const NodeCoordinates c = vessels.nodes.coordinates(node);
    for (int axis = 0; axis < 3; ++axis) {
      const uint32_t after = vessels.nodes.beside(c, axis, 1);
      if (vessels.are_joined(node, axis, after)) vessels.unite(node, after);
    }
  }
};

struct MarkOpen {
  Vessels vessels;

  MENISCUS_HD void operator()(uint32_t node) const {
    if (vessels.is_fluid(node) && is_open(node)) pbd::atomic_max(vessels.sums[vessels.name(node)].open, 1);
  }

  /// Whether a node's faces towards other fluid are not all that holds its pressure.
  MENISCUS_HD bool is_open(uint32_t node) const {
    const NodeCoordinates c = vessels.nodes.coordinates(node);
    const Coefficients own = vessels.coefficients[node];
    float within = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const uint32_t before = vessels.nodes.beside(c, axis, -1), after = vessels.nodes.beside(c, axis, 1);
      if (vessels.is_fluid(before)) within += along(vessels.coefficients[before], axis);
      if (vessels.is_fluid(after)) within += along(own, axis);
    }
    return own.w - within > 1e-6f * own.w;
  }
};

inline constexpr uint32_t in_no_vessel = 0xffffffff;

/// Notes the closed vessel that a node is in, if any, and adds up what there is in it.
struct AddUpVessels {
  Vessels vessels;
  View<const float> right, filled;
  float volume;           ///< m³, of a particle
  View<uint32_t> vessel;  ///< by node

  MENISCUS_HD void operator()(uint32_t node) const {
    vessel[node] = in_no_vessel;
    if (!vessels.is_fluid(node)) return;
    const uint32_t name = vessels.name(node);
    VesselSums& sums = vessels.sums[name];
    if (sums.open) return;
    vessel[node] = name;
    pbd::atomic_add(sums.excess, static_cast<int64_t>(llrintf(VesselSums::unit * right[node] / volume)));
    pbd::atomic_add(sums.filled, static_cast<int64_t>(llrintf(VesselSums::unit * filled[node])));
  }
};

struct TakeSurplus {
  View<const uint32_t> vessel;
  View<const VesselSums> sums;
  View<const float> filled;
  float volume;
  View<float> right;

  MENISCUS_HD void operator()(uint32_t node) const {
    if (vessel[node] == in_no_vessel) return;
    const VesselSums& all = sums[vessel[node]];
    if (all.filled <= 0) return;
    const double surplus = static_cast<double>(all.excess) / static_cast<double>(all.filled);
    right[node] -= volume * static_cast<float>(surplus) * filled[node];
  }
};

struct FindLeast {
  View<const uint32_t> vessel;
  View<const float> pressure;
  View<VesselSums> sums;

  MENISCUS_HD void operator()(uint32_t node) const {
    if (vessel[node] != in_no_vessel) pbd::atomic_max(sums[vessel[node]].least, key_of(pressure[node]));
  }
};

/// The pressure, in a closed vessel from where it is least.
struct PressureOf {
  View<const float> pressure;
  View<const uint32_t> vessel;
  View<const VesselSums> sums;

  MENISCUS_HD float operator()(uint32_t node) const {
    const float p = pressure[node];
    return vessel[node] == in_no_vessel ? p : p - pressure_of(sums[vessel[node]].least);
  }
};

}  // namespace meniscus::fluid::grid_kernels
