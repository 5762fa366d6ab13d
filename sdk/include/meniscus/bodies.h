// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Rigid bodies, what joins them, and what can be read of them. Units as in defs.h.
#pragma once

#include <meniscus/defs.h>

namespace meniscus {

enum class BodyMotion {
  dynamic,    ///< moved by forces, by contacts and by the fluid
  kinematic,  ///< moved by keyframes or by World::move_body; nothing holds it up
};

/// Where a kinematic body is at a time. Between two keyframes its position moves on a line and its rotation
/// about one axis, both at an even rate.
struct Keyframe {
  float time = 0;  ///< s, of World::time; ≥ 0, and later than that of the keyframe before
  Pose pose{};
};

/// Mass and density are > 0, and the mass of a dynamic body is from 1e-20 to 1e20 kg. What Bullet cannot do:
/// bodies of more than 1.4e13 kg fall through other solids, and joints of more than 8e12 kg or kg·m² do not
/// hold; a body turns by 45° at most in one of Bullet's steps, however fast it is said to spin; and further
/// than 10 km from the origin bodies collide with planes alone.
struct BodyDef {
  std::string name;
  BodyMotion motion = BodyMotion::dynamic;
  Geometry geometry =
      BoxGeometry{};  ///< planes and height fields cannot move; a container is for kinematic bodies alone
  Pose pose{};        ///< of the geometry's frame
  Vec3 velocity{0, 0, 0};          ///< m/s, of the centre of mass; 0 for kinematic bodies
  Vec3 angular_velocity{0, 0, 0};  ///< rad/s; 0 for kinematic bodies
  float density = 500.0f;          ///< kg/m³: mass, centre of mass and inertia follow from the geometry
  std::optional<float> mass{};     ///< kg; takes the place of what the density gives
  SurfaceDef surface{};
  CollisionFilter filter{};
  float linear_damping = 0;   ///< share of the velocity lost in a second, 0 to 1
  float angular_damping = 0;  ///< the same of the angular velocity
  /// At rest it is left out of the simulation until something pushes it: at less than 1 % of √(g r) for two
  /// seconds, with r its radius. Not without gravity, nor where cloth or ropes are attached to it.
  bool can_sleep = true;
  std::vector<Keyframe> keyframes{};  ///< kinematic bodies alone; in place of the pose
  bool loop = false;  ///< after the last keyframe starts again at the first; else it stays there
};

// ---- joints ----

/// Holds the two frames together.
struct FixedJoint {};

/// Turns about the frame's y axis.
struct HingeJoint {
  std::optional<float> lower{}, upper{};  ///< rad, from the placement at creation; −π to π; both or neither
  float motor_speed = 0;                  ///< rad/s, of b about a
  float motor_torque = 0;                 ///< N·m, the most that the motor gives; 0: no motor
};

/// Slides along the frame's y axis.
struct SliderJoint {
  std::optional<float> lower{}, upper{};  ///< m, from the placement at creation; −10⁶ to 10⁶; both or neither
  float motor_speed = 0;                  ///< m/s, of b along a
  float motor_force = 0;                  ///< N, the most that the motor gives; 0: no motor
};

/// Turns freely about the frame's origin.
struct BallJoint {};

/// Springs towards the placement at creation, one an axis of the frame. Stiffness is ≥ 0: an axis with none
/// is free, and one with infinite stiffness is held. Damping is finite and ≥ 0; a free axis is not damped.
struct SpringJoint {
  Vec3 stiffness{0, 0, 0};          ///< N/m
  Vec3 damping{0, 0, 0};            ///< N·s/m
  Vec3 angular_stiffness{0, 0, 0};  ///< N·m/rad
  Vec3 angular_damping{0, 0, 0};    ///< N·m·s/rad
};

using JointKind = std::variant<FixedJoint, HingeJoint, SliderJoint, BallJoint, SpringJoint>;

struct JointDef {
  std::string name;
  BodyId a;
  std::optional<BodyId> b{};  ///< another body; left out: the world
  Pose frame{};               ///< of the joint, in the world, at creation
  JointKind kind = BallJoint{};
  bool bodies_collide = false;  ///< whether a and b still collide with one another
};

// ---- read-outs ----

struct BodyState {
  Pose pose{};                     ///< of the geometry's frame
  Vec3 centre_of_mass{0, 0, 0};    ///< m, world
  Vec3 velocity{0, 0, 0};          ///< m/s, of the centre of mass
  Vec3 angular_velocity{0, 0, 0};  ///< rad/s
  Vec3 fluid_force{0, 0, 0};       ///< N, of all particles on it, mean over the last step
  Vec3 fluid_torque{0, 0, 0};      ///< N·m, about the centre of mass, likewise
  bool awake = true;
};

/// Kinematic bodies have none, and read as the defaults.
struct BodyMass {
  float mass = 0;                   ///< kg
  float volume = 0;                 ///< m³
  Vec3 centre{0, 0, 0};             ///< m, of mass, in the geometry's frame
  Vec3 inertia{0, 0, 0};            ///< kg·m², about the principal axes
  Quat principal_axes{0, 0, 0, 1};  ///< from them to the geometry's frame
};

/// A particle that touches a body, a fixed shape or cloth, in the last substep.
struct ParticleContact {
  ParticleId particle = 0;
  BodyId body{};          ///< valid where a body is touched
  ShapeId shape{};        ///< valid where a fixed shape is
  ClothId cloth{};        ///< valid where a piece of cloth is
  Vec3 point{0, 0, 0};    ///< m, on the surface
  Vec3 normal{0, 0, 0};   ///< unit, out of the solid, or off the cloth
  Vec3 impulse{0, 0, 0};  ///< N·s, on the particle; what it touches gets the opposite
};

/// Two solids that touch, or are about to; the first is always a body.
struct SolidContact {
  BodyId a{};
  BodyId b{};            ///< valid where the second is a body
  ShapeId shape{};       ///< valid where the second is a fixed shape
  Vec3 point{0, 0, 0};   ///< m, on b
  Vec3 normal{0, 0, 0};  ///< unit, from b to a
  float distance = 0;    ///< m, negative where they overlap
  float impulse = 0;     ///< N·s along the normal, in Bullet's last step
};

/// Two solids that began or ended to touch in the last step; at least one is a body.
struct ContactEvent {
  BodyId a{};
  BodyId b{};
  ShapeId shape{};
  bool began = true;  ///< else it ended
};

/// What a ray met first.
struct RayHit {
  BodyId body{};    ///< valid where it is a body
  ShapeId shape{};  ///< valid where it is a fixed shape
  std::optional<ParticleId> particle{};
  Vec3 point{0, 0, 0};   ///< m
  Vec3 normal{0, 0, 0};  ///< unit, towards where the ray came from
  float distance = 0;    ///< m along the ray
};

struct Overlaps {
  std::vector<BodyId> bodies;
  std::vector<ShapeId> shapes;
  std::vector<ParticleId> particles;  ///< whose centre lies inside
};

}  // namespace meniscus
