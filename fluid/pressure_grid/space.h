// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The positions of particles, nodes and faces in the pressure grid. Nodes are the corners of the cells by
// which particles are sorted. Face (node, axis) is half way to the next node on that axis.
#pragma once

#include "fluid/pressure_grid/node_table.h"
#include "pbd/contacts.h"
#include "pbd/device/base/view.h"
#include "pbd/ghosts.h"
#include "pbd/grid.h"
#include "pbd/math/vec.h"

namespace meniscus::fluid::grid_kernels {

using pbd::Contact;
using pbd::ContactView;
using pbd::Vec4;
using pbd::View;

/// The position of a particle in its cell, on each axis from 0 to 1.
struct Place {
  NodeCoordinates cell;
  Vec3 t;
};

struct Space {
  pbd::GridView cells;
  NodeTable nodes;
  pbd::GhostExchange::Layers layers{0, 0};  ///< of a slab's world: those of cells with particles

  /// The position of particle i in the cell by which it was sorted, clamped to the cell. Nodes and faces
  /// gather by cells, so both directions of the transfer must use the same cell.
  MENISCUS_HD Vec3 part(Vec3 p, uint32_t i) const {
    pbd::CellCoordinates c = cells.coordinates(p);
    NodeCoordinates cell{{c.x >> 2, c.y, c.z}};  // floor of a quarter
    for (int k = 0; k < 27 && !holds(cell, i); ++k)
      cell = {{(c.x >> 2) + k % 3 - 1, c.y + k / 3 % 3 - 1, c.z + k / 9 - 1}};
    const Vec3 x = cells.inverse_reach * p;
    const auto part = [](float v, int32_t whole) {
      return pbd::clamp(v - static_cast<float>(whole), 0.0f, 1.0f);
    };
    return {part(x.x, cell.at[0]), part(x.y, cell.at[1]), part(x.z, cell.at[2])};
  }
  /// The place of a particle that has this position in its cell.
  MENISCUS_HD Place place(Vec3 p, Vec3 part) const {
    const Vec3 x = cells.inverse_reach * p - part;
    const auto nearest = [](float v) {
      constexpr float limit = 1e9f;  // keeps the conversion defined for any float, NaN included
      return static_cast<int32_t>(rintf(pbd::clamp(v, -limit, limit)));
    };
    return {{{nearest(x.x), nearest(x.y), nearest(x.z)}}, part};
  }
  MENISCUS_HD float width() const { return 1 / cells.inverse_reach; }
  /// The particles of the cell behind a node: its slices are adjacent.
  MENISCUS_HD pbd::Run particles_behind(uint32_t node) const {
    if (cells.is_part) return particles_in_slab(nodes.coordinates(node));
    return {cells.start[slices * node], cells.start[slices * (node + 1)]};
  }

  static constexpr uint32_t slices = pbd::GridView::slices;
  static_assert(slices == 4);

  /// The axis of the layers of a slab.
  MENISCUS_HD int layer_axis() const { return cells.layers_along_y ? 1 : 2; }

 private:
  /// The table of a slab has the cells of its own layers and of its ghosts.
  MENISCUS_HD pbd::Run particles_in_slab(NodeCoordinates c) const {
    const int axis = layer_axis();
    const uint32_t from_first = (static_cast<uint32_t>(c.at[axis]) - static_cast<uint32_t>(layers.first)) &
                                ((1u << nodes.bits[axis]) - 1);
    c.at[axis] = layers.first + static_cast<int32_t>(from_first);
    if (c.at[axis] >= layers.end) return {0, 0};
    const pbd::CellCoordinates cell{static_cast<int32_t>(slices) * c.at[0], c.at[1], c.at[2]};
    if (!cells.holds(cell)) return {0, 0};
    const uint32_t first = cells.key(cell);
    return {cells.start[first], cells.start[first + slices]};
  }
  MENISCUS_HD bool holds(const NodeCoordinates& cell, uint32_t i) const {
    const pbd::Run run = particles_behind(nodes.index(cell));
    return run.begin <= i && i < run.end;
  }
};

MENISCUS_HD inline float component(Vec3 v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

/// Calls visit(node, weight) for the eight nodes around a particle. Weights are trilinear, and add up to 1.
template <class Visit>
MENISCUS_HD void for_each_node(const NodeTable& nodes, const Place& p, const Visit& visit) {
  MENISCUS_UNROLL
  for (int k = 0; k < 8; ++k) {
    const int x = k & 1, y = k >> 1 & 1, z = k >> 2;
    const float weight = (x ? p.t.x : 1 - p.t.x) * (y ? p.t.y : 1 - p.t.y) * (z ? p.t.z : 1 - p.t.z);
    visit(nodes.index(p.cell.at[0] + x, p.cell.at[1] + y, p.cell.at[2] + z), weight);
  }
}

/// The same for the eight faces of one axis.
template <class Visit>
MENISCUS_HD void for_each_face(const NodeTable& nodes, const Place& p, int axis, const Visit& visit) {
  Place shifted = p;
  const bool before = component(p.t, axis) < 0.5f;
  float* t = axis == 0 ? &shifted.t.x : axis == 1 ? &shifted.t.y : &shifted.t.z;
  *t += before ? 0.5f : -0.5f;
  shifted.cell.at[axis] -= before ? 1 : 0;
  for_each_node(nodes, shifted, visit);
}

/// Of one particle: x, y, z: its position in its cell, from 0 to 1; w: its excess.
using Found = Vec4;

/// Calls visit(particle, offset to the node in widths of a cell) for the particles of the eight cells around.
/// Skips cells for which `wanted(first, end)`, called with their range of particles, is false. The cells of
/// the layer before the node come first.
template <class Wanted, class Visit>
MENISCUS_HD void for_each_around(const Space& space, uint32_t node, View<const Found> found,
                                 const Wanted& wanted, const Visit& visit) {
  const NodeCoordinates c = space.nodes.coordinates(node);
  for (int k = 0; k < 8; ++k) {
    // 0: the cell lies before the node
    const int x = k & 1, across = k >> 1 & 1, layer = k >> 2;
    const int y = space.cells.layers_along_y ? layer : across,
              z = space.cells.layers_along_y ? across : layer;
    const uint32_t cell = space.nodes.index(c.at[0] + x - 1, c.at[1] + y - 1, c.at[2] + z - 1);
    const auto [first, end] = space.particles_behind(cell);
    if (first == end || !wanted(first, end)) continue;
    for (uint32_t i = first; i < end; ++i) {
      const Vec3 t = found[i].xyz();
      visit(i, Vec3{x ? -t.x : 1 - t.x, y ? -t.y : 1 - t.y, z ? -t.z : 1 - t.z});
    }
  }
}

struct AllCells {
  MENISCUS_HD bool operator()(uint32_t, uint32_t) const { return true; }
};

/// The contacts of cells: contacts are in the order of their particles. Ghosts have none.
struct TouchingCells {
  View<const uint32_t> contact_start;

  MENISCUS_HD bool operator()(uint32_t first, uint32_t end) const {
    return end < contact_start.count && contact_start[first] != contact_start[end];
  }
};

/// The weight of a particle on a node at this offset, in widths of a cell.
MENISCUS_HD inline float node_weight(Vec3 away) {
  return (1 - fabsf(away.x)) * (1 - fabsf(away.y)) * (1 - fabsf(away.z));
}

}  // namespace meniscus::fluid::grid_kernels
