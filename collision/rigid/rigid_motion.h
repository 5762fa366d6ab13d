// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Data that the rigid world and the particles exchange once a substep.
#pragma once

#include <meniscus/types.h>

namespace meniscus::collision {

/// Data of a body that particles need for a substep. Poses are of the principal frame. Its origin is the
/// centre of mass, and its axes are those of the inertia.
struct RigidMotion {
  Pose start;     ///< now
  Vec3 velocity;  ///< m/s, with the forces that Bullet will integrate, so that the body is predicted at
                  ///< start.position + dt · velocity
  Vec3 angular_velocity;  ///< rad/s, likewise
  /// A body that other solids hold or load gives way along `loaded`, and tilts against it, by the fraction
  /// `yielding` of what it would alone. `loaded` is a unit vector, or 0.
  Vec3 loaded{0, 0, 0};
  float yielding = 1;
  bool is_held = false;  ///< other solids touch it, or may in this substep
};

struct RigidMass {
  float inverse_mass;    ///< 1/kg; 0 for kinematic bodies
  Vec3 inverse_inertia;  ///< 1/(kg m²), principal
  Pose principal;        ///< the principal frame in the geometry's frame
};

struct RigidImpulse {
  Vec3 linear;   ///< N·s
  Vec3 angular;  ///< N·m·s, about the centre of mass
};

}  // namespace meniscus::collision
