// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Classifies the nodes of the pressure grid: in fluid, in a solid or in air.
#pragma once

#include "fluid/pressure_grid/node_layers.h"
#include "fluid/pressure_grid/space.h"
#include "fluid/pressure_grid/tuning.h"

namespace meniscus::fluid::grid_kernels {

/// Flags of a node and its surroundings.
enum NodeFlags : uint32_t {
  node_fluid = 1,       ///< its pressure is an unknown
  node_solid = 2,       ///< it is in a solid
  node_touched = 4,     ///< near contacts
  node_wall_below = 8,  ///< the node before it on x is in a solid; then after it; then y and z
};

MENISCUS_HD inline uint32_t wall_flag(int axis, bool after) {
  return node_wall_below << (2 * axis + (after ? 1 : 0));
}

enum class Face { none, open, closed };

struct NodeMap {
  NodeTable nodes;
  View<const uint32_t> flags;

  /// A face is closed where there is fluid on one side and a solid on the other.
  MENISCUS_HD Face face(uint32_t node, int axis) const {
    const uint32_t other = nodes.beside(nodes.coordinates(node), axis, 1);
    return between(flags[node], flags[other], axis);
  }
  MENISCUS_HD static Face between(uint32_t before, uint32_t after, int axis) {
    const bool a = before & node_fluid, b = after & node_fluid;
    if (a && b) return Face::open;
    if (a) return before & wall_flag(axis, true) ? Face::closed : Face::open;
    if (b) return after & wall_flag(axis, false) ? Face::closed : Face::open;
    return Face::none;
  }
};

/// The fraction of a node's volume behind a plane at this distance, in widths of a cell.
MENISCUS_HD inline float fraction_behind(float distance) {
  const float a = pbd::max(0.0f, 1 - fabsf(distance)), half = 0.5f * a * a;
  return distance > 0 ? half : 1 - half;
}

/// The inputs of the classification.
struct NodeSources {
  Space space;
  View<const Found> found;
  View<const Vec4> position;
  ContactView contacts;
  float volume;  ///< m³, of a particle
};

/// The surfaces around a node, as seen from the particle that touches most of them. Lengths are in widths
/// of a cell.
struct Walls {
  float open = 1, distance = 1;
  float beside[6] = {1, 1, 1, 1, 1, 1};  ///< distances of the adjacent nodes
  uint32_t touched = 0;                  ///< 1 if any particle touches a surface

  MENISCUS_HD void add(float fraction_open, float plane, Vec3 normal) {
    touched = 1;
    open = pbd::min(open, fraction_open);
    distance = pbd::min(distance, plane);
    MENISCUS_UNROLL
    for (int b = 0; b < 6; ++b) {
      const float step = component(normal, b / 2);
      beside[b] = pbd::min(beside[b], plane + (b % 2 ? step : -step));
    }
  }
  MENISCUS_HD void add(const Walls& other) {
    touched |= other.touched;
    open *= other.open;
    distance = pbd::min(distance, other.distance);
    MENISCUS_UNROLL
    for (int b = 0; b < 6; ++b) beside[b] = pbd::min(beside[b], other.beside[b]);
  }
};

/// Classifies a node: it is fluid if particles fill half of the volume that solids leave. Without
/// `any_moving` there is no cloth.
template <bool any_moving>
struct GatherNodes {
  NodeSources from;
  View<uint32_t> flags;
  View<float> filled;  ///< the fraction of the node's volume that particles fill
  FromBelow<Walls> below{};

  /// What is visible from a node.
  struct Sight {
    float weight = 0;  ///< of all particles
    float hidden = 0;  ///< of particles hidden by cloth
    Walls solids, sheets;
  };

  MENISCUS_HD void operator()(uint32_t node) const {
    Sight sight;
    for_each_around(from.space, node, from.found, AllCells{},
                    [&](uint32_t, Vec3 away) { sight.weight += node_weight(away); });
    sight.solids = below.of(node);
    look_at_surfaces(node, sight);
    const float inverse_width = from.space.cells.inverse_reach;
    const float filled_fraction = from.volume * inverse_width * inverse_width * inverse_width * sight.weight;
    flags[node] = flags_of(sight, filled_fraction);
    filled[node] = filled_fraction;
  }

  MENISCUS_HD void look_at_surfaces(uint32_t node, Sight& sight) const {
    for_each_around(from.space, node, from.found, TouchingCells{from.contacts.start},
                    [&](uint32_t i, Vec3 away) { add(sight, i, away); });
  }

  MENISCUS_HD void add(Sight& sight, uint32_t i, Vec3 away) const {
    const float weight = node_weight(away);
    if (weight < grid_tuning::least_weight) return;
    float open = 1, open_by_cloth = 1;
    bool hidden = false;
    for (uint32_t k = from.contacts.start[i]; k < from.contacts.start[i + 1]; ++k) {
      const Contact& c = from.contacts.contacts[k];
      if (pbd::is_attachment(c) || c.fraction < grid_tuning::least_wall) continue;
      const float distance =
          from.space.cells.inverse_reach * plane_distance(c, from.position[i].xyz()) + dot(c.normal, away);
      const float open_fraction = 1 - fraction_behind(distance);
      if (any_moving && c.body == pbd::on_cloth) {
        sight.sheets.add(open_by_cloth *= open_fraction, distance, c.normal);
        hidden = hidden || distance < 0;
      } else {
        sight.solids.add(open *= open_fraction, distance, c.normal);
      }
    }
    if (hidden) sight.hidden += weight;
  }

  /// Cloth is a wall where there is fluid on one of its sides.
  MENISCUS_HD static uint32_t flags_of(const Sight& sight, float filled_fraction) {
    using namespace grid_tuning;
    Walls walls = sight.solids;
    const float seen = sight.weight - sight.hidden;
    if (any_moving && pbd::min(seen, sight.hidden) <= dry_side * sight.weight) walls.add(sight.sheets);
    uint32_t flags = walls.touched ? node_touched : 0u;
    if (walls.distance < deepest)
      flags |= node_solid;
    else if (filled_fraction >
             (walls.open < mostly_open ? filled_beside_walls : grid_tuning::filled) * walls.open)
      flags |= node_fluid;
    for (int b = 0; b < 6; ++b) {
      if (walls.beside[b] < deepest) flags |= wall_flag(b / 2, b % 2);
    }
    return flags;
  }
};

/// For the rank above: the surfaces around the nodes of its first layer, as seen from particles of this rank.
struct WallsAbove {
  NodeLayers layers;
  GatherNodes<false> gather;
  View<Walls> walls;

  MENISCUS_HD void operator()(uint32_t k) const {
    GatherNodes<false>::Sight sight;
    gather.look_at_surfaces(layers.node(k), sight);
    walls[k] = sight.solids;
  }
};

/// Marks the nodes with fluid on all sides.
struct MarkInside {
  NodeTable nodes;
  View<const uint32_t> flags;
  View<uint32_t> inside;

  MENISCUS_HD void operator()(uint32_t node) const {
    const NodeCoordinates c = nodes.coordinates(node);
    uint32_t all = flags[node];
    for (int axis = 0; axis < 3; ++axis)
      all &= flags[nodes.beside(c, axis, -1)] & flags[nodes.beside(c, axis, 1)];
    inside[node] = all & node_fluid;
  }
};

}  // namespace meniscus::fluid::grid_kernels
