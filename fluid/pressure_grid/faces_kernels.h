// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The faces between the nodes of the pressure grid, and the equation that they form.
#pragma once

#include "fluid/pressure_grid/multigrid_kernels.h"
#include "fluid/pressure_grid/nodes_kernels.h"
#include "fluid/pressure_grid/tuning.h"
#include "pbd/neighbours.h"

namespace meniscus::fluid::grid_kernels {

using multigrid_kernels::along;
using multigrid_kernels::Coefficients;

/// The factors for a particle's weights on the faces of each axis, such that the weights of faces that can
/// move it add up to 1. The factor is 0 if these weights almost vanish.
struct Normalize {
  Space space;
  NodeMap map;
  View<const uint32_t> inside;
  View<const Vec4> position;
  pbd::NeighbourView neighbours;
  View<Vec4> scale;   ///< w: mass, kg; 0 for particles that take no part
  View<Found> found;  ///< weights on nodes in solids are moved to the other nodes

  MENISCUS_HD void operator()(uint32_t i) const {
    if (neighbours.size(i) < grid_tuning::least_neighbours) {
      scale[i] = {0, 0, 0, 0};
      found[i].w = 0;
      return;
    }
    const Vec4 p = position[i];
    const Place place = space.place(p.xyz(), found[i].xyz());
    uint32_t all = node_fluid;
    for_each_node(space.nodes, place, [&](uint32_t node, float) { all &= inside[node]; });
    if (all) {
      scale[i] = {1, 1, 1, mass_of(i)};
      return;
    }
    found[i].w /= pbd::max(outside_solids(place), grid_tuning::least_outside);
    scale[i] = {inverse_total(place, 0), inverse_total(place, 1), inverse_total(place, 2), mass_of(i)};
  }

  MENISCUS_HD float inverse_total(const Place& place, int axis) const {
    float total = 0;
    for_each_face(space.nodes, place, axis, [&](uint32_t node, float weight) {
      if (map.face(node, axis) != Face::none) total += weight;
    });
    return total > grid_tuning::least_on_faces ? 1 / total : 0.0f;
  }

  MENISCUS_HD float outside_solids(const Place& place) const {
    float total = 0;
    for_each_node(space.nodes, place, [&](uint32_t node, float weight) {
      if (!(map.flags[node] & node_solid)) total += weight;
    });
    return total;
  }

  MENISCUS_HD float mass_of(uint32_t i) const {
    const float w = position[i].w;
    return w > 0 ? 1 / w : 0.0f;
  }
};

/// A face as the pressure solve sees it.
struct FaceState {
  float area = 0;  ///< the open fraction
  float mass = 0;  ///< kg, of the particles that it moves
  /// 1/kg. For a face with very little mass it is less than 1/mass; otherwise spray would get high speeds.
  float inverse_mass = 0;
};

/// All faces of one node.
struct alignas(8) NodeFaces {
  FaceState face[3];
};

struct GatherFaces {
  Space space;
  NodeMap map;
  View<const Found> found;
  View<const Vec4> scale;
  float volume;
  View<NodeFaces> faces;

  MENISCUS_HD void operator()(uint32_t k) const {
    const int axis = static_cast<int>(k / space.nodes.count());
    const uint32_t node = k % space.nodes.count();
    faces[node].face[axis] = map.face(node, axis) == Face::open ? gather(node, axis) : FaceState{};
  }

  /// The sums of a face over its particles.
  struct Sums {
    float mass = 0, filled = 0, heaviest = 0;

    MENISCUS_HD void add(float weight, const Vec4& self, int axis) {
      filled += weight * along(self, axis);
      mass += weight * along(self, axis) * self.w;
      heaviest = pbd::max(heaviest, self.w);
    }
  };

  MENISCUS_HD FaceState gather(uint32_t node, int axis) const {
    const NodeCoordinates c = space.nodes.coordinates(node);
    Sums sums;
    for (int k = 0; k < 12; ++k) gather_cell(c, axis, {k % 3 - 1, k / 3 % 2 - 1, k / 6 - 1}, sums);
    // If solids are near only one of the two nodes, they are too far away to close any part of the face. No
    // contact could take the rest of the other node's pressure.
    const uint32_t both = map.flags[node] & map.flags[space.nodes.beside(c, axis, 1)];
    const float inverse_width = space.cells.inverse_reach;
    const float fraction = sums.filled * volume * inverse_width * inverse_width * inverse_width;
    return {both & node_touched ? pbd::min(1.0f, fraction) : 1.0f, sums.mass,
            sums.mass > 0 ? 1 / pbd::max(sums.mass, grid_tuning::least_face_mass * sums.heaviest) : 0.0f};
  }

  /// The offset of a cell from the cell behind the face's node: along the face's axis, and across it.
  struct Offset {
    int along_axis, side, other;
  };

  MENISCUS_HD void gather_cell(NodeCoordinates cell, int axis, Offset offset, Sums& sums) const {
    const int side = (axis + 1) % 3, other = (axis + 2) % 3;
    cell.at[axis] += offset.along_axis;
    cell.at[side] += offset.side;
    cell.at[other] += offset.other;
    const pbd::Run run = space.particles_behind(space.nodes.index(cell));
    for (uint32_t i = run.begin; i < run.end; ++i) {
      const Vec3 t = found[i].xyz();
      const float away = fabsf(static_cast<float>(offset.along_axis) + component(t, axis) - 0.5f);
      if (away >= 1) continue;
      const float ts = component(t, side), to = component(t, other);
      const float weight = (1 - away) * (offset.side ? ts : 1 - ts) * (offset.other ? to : 1 - to);
      sums.add(weight, scale[i], axis);
    }
  }
};

/// The equation: the flux that a pressure P, in kg·m/m², drives through a face is a² H⁴ P/M.
struct MakeEquation {
  NodeTable nodes;
  View<const uint32_t> flags;
  View<const NodeFaces> faces;
  View<const float> filled;
  float width2;      ///< H², m²
  float compliance;  ///< m⁴/kg, of a whole node
  View<const float> give;
  View<Coefficients> coefficients;

  MENISCUS_HD float coefficient(uint32_t node, int axis) const {
    const FaceState f = faces[node].face[axis];
    return width2 * width2 * f.area * f.area * f.inverse_mass;
  }

  MENISCUS_HD void operator()(uint32_t node) const {
    const NodeCoordinates c = nodes.coordinates(node);
    Coefficients self{coefficient(node, 0), coefficient(node, 1), coefficient(node, 2), 0};
    if (flags[node] & node_fluid) {
      float sum = self.x + self.y + self.z;
      for (int axis = 0; axis < 3; ++axis) sum += coefficient(nodes.beside(c, axis, -1), axis);
      self.w = sum + compliance * filled[node] + give[node];
    }
    coefficients[node] = self;
  }
};

}  // namespace meniscus::fluid::grid_kernels
