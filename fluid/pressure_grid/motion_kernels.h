// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// How the pressure of the grid moves faces, and how faces move particles.
#pragma once

#include "fluid/pressure_grid/sealed_component_kernels.h"
#include "fluid/pressure_grid/tuning.h"

namespace meniscus::fluid::grid_kernels {

/// The displacement of particles by each face.
struct FaceMoves {
  NodeTable nodes;
  View<const NodeFaces> faces;
  View<const float> pressure;
  float width2;
  float fraction;  ///< of the whole displacement
  float limit;     ///< m

  /// kg·m
  MENISCUS_HD float impulse(const NodeCoordinates& c, uint32_t node, int axis) const {
    const float pressure_drop = pressure[node] - pressure[nodes.beside(c, axis, 1)];
    return fraction * faces[node].face[axis].area * width2 * pressure_drop;
  }
  /// m
  MENISCUS_HD float displacement(const NodeCoordinates& c, uint32_t node, int axis) const {
    return pbd::clamp(faces[node].face[axis].inverse_mass * impulse(c, node, axis), -limit, limit);
  }
};

/// The impulse that faces do not transfer, because they move little or nothing or their displacement is
/// limited, and the mass of all moving faces.
struct Lost {
  double impulse[3] = {0, 0, 0}, mass[3] = {0, 0, 0};
};

struct AddLost {
  MENISCUS_HD Lost operator()(Lost a, const Lost& b) const {
    for (int axis = 0; axis < 3; ++axis) {
      a.impulse[axis] += b.impulse[axis];
      a.mass[axis] += b.mass[axis];
    }
    return a;
  }
};

struct FindLost {
  FaceMoves moves;
  View<const uint32_t> flags;
  PressureOf pressure;

  MENISCUS_HD Lost operator()(uint32_t node) const {
    const NodeCoordinates c = moves.nodes.coordinates(node);
    Lost lost;
    for (int axis = 0; axis < 3; ++axis) {
      const FaceState face = moves.faces[node].face[axis];
      if (face.mass > 0) {
        lost.mass[axis] = double{face.mass};
        lost.impulse[axis] = double{moves.impulse(c, node, axis)} -
                             double{face.mass} * double{moves.displacement(c, node, axis)};
      } else if (face.area > 0) {
        const float pressure_drop = in_the_open(node) - in_the_open(moves.nodes.beside(c, axis, 1));
        lost.impulse[axis] = double{moves.fraction * face.area * moves.width2 * pressure_drop};
      }
    }
    return lost;
  }

  /// The pressure of a node on faces that move no particle. Near solids it is 0, as the solids take it up:
  /// see WallAreas.
  MENISCUS_HD float in_the_open(uint32_t node) const {
    return flags[node] & node_touched ? 0.0f : pressure(node);
  }
};

/// Distributes the lost impulse over everything that moves.
struct MoveFaces {
  FaceMoves moves;
  View<const Lost> lost;
  View<Vec4> motion;

  MENISCUS_HD void operator()(uint32_t node) const {
    const NodeCoordinates c = moves.nodes.coordinates(node);
    const Lost& all = lost[0];
    float displacement[3] = {0, 0, 0};
    for (int axis = 0; axis < 3; ++axis) {
      if (moves.faces[node].face[axis].mass > 0)
        displacement[axis] =
            moves.displacement(c, node, axis) + static_cast<float>(all.impulse[axis] / all.mass[axis]);
    }
    motion[node] = {displacement[0], displacement[1], displacement[2], 0};
  }
};

struct MoveParticles {
  Space space;
  View<const Found> found;
  pbd::NeighbourView neighbours;
  View<const Vec4> scale;
  View<const Vec4> motion;
  View<const uint32_t> flags;
  PressureOf pressure;
  float to_multiplier;  ///< m³
  View<Vec4> position, accumulated_delta;
  View<float> multiplier;  ///< kg·m², in the units of the density constraint's multipliers

  MENISCUS_HD void operator()(uint32_t i) const {
    if (neighbours.size(i) < grid_tuning::least_neighbours) {
      multiplier[i] = 0;
      return;
    }
    const Vec4 p = position[i];
    const Place place = space.place(p.xyz(), found[i].xyz());
    const Vec3 displacement = displacement_of(place, scale[i]);
    multiplier[i] = to_multiplier * pressure_at(place);
    position[i] = pbd::with_w(p.xyz() + displacement, p.w);
    accumulated_delta[i] = pbd::shifted(accumulated_delta[i], displacement);
  }

  MENISCUS_HD Vec3 displacement_of(const Place& place, const Vec4& self) const {
    float displacement[3] = {0, 0, 0};
    if (!(self.w > 0)) return {0, 0, 0};
    for (int axis = 0; axis < 3; ++axis) {
      for_each_face(space.nodes, place, axis, [&](uint32_t node, float weight) {
        displacement[axis] += weight * along(motion[node], axis);
      });
      displacement[axis] *= along(self, axis);
    }
    return {displacement[0], displacement[1], displacement[2]};
  }

  MENISCUS_HD float pressure_at(const Place& place) const {
    float sum = 0, weights = 0;
    for_each_node(space.nodes, place, [&](uint32_t node, float weight) {
      if (flags[node] & node_solid) return;
      sum += weight * pressure(node);
      weights += weight;
    });
    return weights > 0 ? sum / weights : 0.0f;
  }
};

}  // namespace meniscus::fluid::grid_kernels
