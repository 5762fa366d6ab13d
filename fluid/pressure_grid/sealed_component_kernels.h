// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of sealed_components.h. Nodes that are joined by open faces form a component of fluid, which is
// named by its greatest node.
#pragma once

#include <cstring>

#include "fluid/pressure_grid/faces_kernels.h"
#include "fluid/pressure_grid/tuning.h"
#include "pbd/math/union_find.h"

namespace meniscus::fluid::grid_kernels {

/// The sums of a component, at the node that names it. They are integers, so they do not depend on the order.
struct ComponentSums {
  int64_t excess;  ///< in particles' volumes / `unit`
  int64_t filled;  ///< in nodes' volumes / `unit`
  uint32_t open;   ///< 1 where the component is not sealed
  uint32_t least;  ///< the key of the least pressure

  static constexpr float unit = 1 << 20;
};

/// Greater for lower pressures; never 0.
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

struct Components {
  NodeTable nodes;
  View<const uint32_t> flags;
  View<const Coefficients> coefficients;
  View<uint32_t> label;
  View<ComponentSums> sums;

  MENISCUS_HD bool is_fluid(uint32_t node) const { return (flags[node] & node_fluid) != 0; }

  MENISCUS_HD bool are_joined(uint32_t node, int axis, uint32_t after) const {
    return is_fluid(node) && along(coefficients[node], axis) > 0 && is_fluid(after);
  }

  MENISCUS_HD uint32_t name(uint32_t node) const { return pbd::UnionFind{label}.name(node); }
  MENISCUS_HD void unite(uint32_t a, uint32_t b) const { pbd::UnionFind{label}.unite(a, b); }
};

struct StartComponents {
  Components components;

  MENISCUS_HD void operator()(uint32_t node) const {
    components.label[node] = first_above(node);
    components.sums[node] = {0, 0, 0, 0};
  }

  /// Most nodes are united by this alone. The table wraps around, so the next node may have a lower number.
  MENISCUS_HD uint32_t first_above(uint32_t node) const {
    const NodeCoordinates c = components.nodes.coordinates(node);
    for (int axis = 0; axis < 3; ++axis) {
      const uint32_t after = components.nodes.beside(c, axis, 1);
      if (after > node && components.are_joined(node, axis, after)) return after;
    }
    return node;
  }
};

struct UniteNodes {
  Components components;

  MENISCUS_HD void operator()(uint32_t node) const {
    if (!components.is_fluid(node)) return;
    const NodeCoordinates c = components.nodes.coordinates(node);
    for (int axis = 0; axis < 3; ++axis) {
      const uint32_t after = components.nodes.beside(c, axis, 1);
      if (components.are_joined(node, axis, after)) components.unite(node, after);
    }
  }
};

struct MarkOpen {
  Components components;

  MENISCUS_HD void operator()(uint32_t node) const {
    if (components.is_fluid(node) && is_open(node))
      pbd::atomic_max(components.sums[components.name(node)].open, 1);
  }

  /// Whether anything but the faces towards other fluid nodes determines the pressure of a node.
  MENISCUS_HD bool is_open(uint32_t node) const {
    const NodeCoordinates c = components.nodes.coordinates(node);
    const Coefficients self = components.coefficients[node];
    float within = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const uint32_t before = components.nodes.beside(c, axis, -1),
                     after = components.nodes.beside(c, axis, 1);
      if (components.is_fluid(before)) within += along(components.coefficients[before], axis);
      if (components.is_fluid(after)) within += along(self, axis);
    }
    return self.w - within > grid_tuning::sealed_rounding * self.w;
  }
};

inline constexpr uint32_t in_no_component = 0xffffffff;

/// Records the sealed component of a node, if any, and adds the node to its sums.
struct AddUpComponents {
  Components components;
  View<const float> right, filled;
  float volume;              ///< m³, of a particle
  View<uint32_t> component;  ///< by node

  MENISCUS_HD void operator()(uint32_t node) const {
    component[node] = in_no_component;
    if (!components.is_fluid(node)) return;
    const uint32_t name = components.name(node);
    ComponentSums& sums = components.sums[name];
    if (sums.open) return;
    component[node] = name;
    pbd::atomic_add(sums.excess, static_cast<int64_t>(llrintf(ComponentSums::unit * right[node] / volume)));
    pbd::atomic_add(sums.filled, static_cast<int64_t>(llrintf(ComponentSums::unit * filled[node])));
  }
};

struct TakeSurplus {
  View<const uint32_t> component;
  View<const ComponentSums> sums;
  View<const float> filled;
  float volume;
  View<float> right;

  MENISCUS_HD void operator()(uint32_t node) const {
    if (component[node] == in_no_component) return;
    const ComponentSums& all = sums[component[node]];
    if (all.filled <= 0) return;
    const double surplus = static_cast<double>(all.excess) / static_cast<double>(all.filled);
    right[node] -= volume * static_cast<float>(surplus) * filled[node];
  }
};

struct FindLeast {
  View<const uint32_t> component;
  View<const float> pressure;
  View<ComponentSums> sums;

  MENISCUS_HD void operator()(uint32_t node) const {
    if (component[node] != in_no_component)
      pbd::atomic_max(sums[component[node]].least, key_of(pressure[node]));
  }
};

/// The pressure; in a sealed component, relative to its least pressure.
struct PressureOf {
  View<const float> pressure;
  View<const uint32_t> component;
  View<const ComponentSums> sums;

  MENISCUS_HD float operator()(uint32_t node) const {
    const float p = pressure[node];
    return component[node] == in_no_component ? p : p - pressure_of(sums[component[node]].least);
  }
};

}  // namespace meniscus::fluid::grid_kernels
