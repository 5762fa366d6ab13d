// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Probes measure while a world steps. Units as in defs.h.
#pragma once

#include <meniscus/ids.h>
#include <meniscus/types.h>

#include <optional>
#include <string>

namespace meniscus {

/// What a probe measures.
enum class ProbeKind {
  point_pressure,  ///< Pa, kernel-weighted mean within a support radius of a point; 0 without fluid
  wall_pressure,   ///< Pa, wall_force on the patch over ProbeDef::area; contains friction, never < 0
  wall_force,      ///< N, vector: the particles' force on a patch of a shape or on all of it
  wall_torque,     ///< N·m, vector: of the same forces, about ProbeDef::point
  point_velocity,  ///< m/s, vector: mean of the particles within a support radius of a point; 0 without any
  point_density,   ///< kg/m³, of all particles within a support radius of a point; less beside walls
  flow,            ///< m³/s through a disc, along its normal
  /// m: height of the free surface over a point, in a column along a normal. The column counts from the point
  /// up to the first layer that is less than half full, so that spray above the pool does not count.
  level,
  fluid_momentum,          ///< kg·m/s, vector
  fluid_angular_momentum,  ///< kg·m²/s, vector, about ProbeDef::point
  fluid_centre,            ///< m, vector: centre of mass; 0 without particles
};

/// A measurement: the mean over the substeps of a step. Forces are averaged as vectors.
struct ProbeDef {
  std::string name{};                          ///< what World::find_probe takes
  ProbeKind kind = ProbeKind::point_pressure;  ///< what it measures
  Vec3 point{0, 0, 0};             ///< m; not of wall_pressure, wall_force, fluid_momentum and fluid_centre
  Vec3 normal{0, 1, 0};            ///< flow and level alone; of a length from 1e-6 to 1e18
  float radius = 0.0f;             ///< m, > 0, of the disc or column; flow and level alone
  std::optional<FluidId> fluid{};  ///< or granular material; none: all. fluid_* alone
  ShapeId shape{};                 ///< wall_* alone
  std::optional<Aabb> patch{};     ///< contacts inside this box count; wall_pressure needs it and its area
  float area = 0.0f;               ///< m², of the patch; wall_pressure alone
};

}  // namespace meniscus
