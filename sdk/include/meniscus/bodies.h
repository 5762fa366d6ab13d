// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Rigid bodies, joints, and their read-outs. Units as in defs.h.
#pragma once

#include <meniscus/defs.h>

namespace meniscus {

/// What moves a body.
enum class BodyMotion {
  dynamic,    ///< moved by forces, contacts and fluid
  kinematic,  ///< moved by keyframes or World::move_body alone; nothing stops it
};

/// The pose of a kinematic body at a time. Between two keyframes it moves along a line and rotates about one
/// axis, both at a constant rate.
struct Keyframe {
  float time = 0;  ///< s, of World::time; ≥ 0 and later than the keyframe before
  Pose pose{};     ///< of the geometry's frame
};

/// Mass and density are > 0. The mass of a dynamic body is from 1e-20 to 1e20 kg.
///
/// Limits of Bullet: bodies of more than 1.4e13 kg fall through other solids. Joints of more than 8e12 kg or
/// kg·m² do not hold. A body rotates by at most 45° in one step of Bullet, whatever its angular velocity.
/// Further than 10 km from WorldDef::origin, bodies collide with planes alone.
struct BodyDef {
  std::string name{};                       ///< what World::find_body takes
  BodyMotion motion = BodyMotion::dynamic;  ///< what moves it
  Geometry geometry = BoxGeometry{};  ///< no plane or height field; a container for kinematic bodies alone
  Pose pose{};                        ///< of the geometry's frame
  Vec3 velocity{0, 0, 0};             ///< m/s, of the centre of mass; 0 for kinematic bodies
  Vec3 angular_velocity{0, 0, 0};     ///< rad/s; 0 for kinematic bodies
  float density = 500.0f;             ///< kg/m³: mass, centre of mass and inertia follow from the geometry
  std::optional<float> mass{};        ///< kg; replaces the mass that follows from the density
  SurfaceDef surface{};               ///< its contacts with particles, cloth and solids
  CollisionFilter filter{};           ///< what it collides with
  float linear_damping = 0;           ///< fraction of the velocity that is lost in a second, 0 to 1
  float angular_damping = 0;          ///< the same for the angular velocity
  /// A body that is slower than 1 % of √(g r) for two seconds, with r its radius, sleeps. It is then left out
  /// of the simulation until something pushes it. Bodies do not sleep without gravity, or while cloth or
  /// ropes are attached to them.
  bool can_sleep = true;
  std::vector<Keyframe> keyframes{};  ///< kinematic bodies alone; they replace the pose
  /// Whether the first keyframe follows the last; else the body stays there. It needs at least 2 keyframes.
  bool loop = false;
};

// ---- joints ----

/// Keeps the two frames together.
struct FixedJoint {};

/// Rotates about the y axis of the frame.
struct HingeJoint {
  std::optional<float> lower{}, upper{};  ///< rad, from the pose at creation; −π to π; both or neither
  float motor_speed = 0;                  ///< rad/s, of b about a
  float motor_torque = 0;                 ///< N·m, the largest torque of the motor; 0: no motor
};

/// Slides along the y axis of the frame.
struct SliderJoint {
  std::optional<float> lower{}, upper{};  ///< m, from the pose at creation; −10⁶ to 10⁶; both or neither
  float motor_speed = 0;                  ///< m/s, of b along a
  float motor_force = 0;                  ///< N, the largest force of the motor; 0: no motor
};

/// Rotates freely about the origin of the frame.
struct BallJoint {};

/// Springs towards the pose at creation, one for each axis of the frame. Stiffness is ≥ 0. An axis with
/// stiffness 0 is free, and one with infinite stiffness is fixed. Damping is finite and ≥ 0. A free axis is
/// not damped.
struct SpringJoint {
  Vec3 stiffness{0, 0, 0};          ///< N/m
  Vec3 damping{0, 0, 0};            ///< N·s/m
  Vec3 angular_stiffness{0, 0, 0};  ///< N·m/rad
  Vec3 angular_damping{0, 0, 0};    ///< N·m·s/rad
};

/// What a joint allows.
using JointKind = std::variant<FixedJoint, HingeJoint, SliderJoint, BallJoint, SpringJoint>;

/// A joint between a body and another one, or the world.
struct JointDef {
  std::string name{};            ///< what World::find_joint takes
  BodyId a;                      ///< a body
  std::optional<BodyId> b{};     ///< another body; none: the world
  Pose frame{};                  ///< of the joint, in the world, at creation
  JointKind kind = BallJoint{};  ///< what it allows
  bool bodies_collide = false;   ///< whether a and b collide with one another
};

// ---- read-outs ----

/// Where a body is, how it moves, and what the fluid does to it.
struct BodyState {
  Pose pose{};                     ///< of the geometry's frame
  Vec3 centre_of_mass{0, 0, 0};    ///< m, world
  Vec3 velocity{0, 0, 0};          ///< m/s, of the centre of mass
  Vec3 angular_velocity{0, 0, 0};  ///< rad/s
  Vec3 fluid_force{0, 0, 0};       ///< N, of all particles on the body, mean over the last step
  Vec3 fluid_torque{0, 0, 0};      ///< N·m, about the centre of mass, likewise
  bool awake = true;               ///< left out of the simulation while it rests, if not
};

/// Kinematic bodies have no mass. Their values are the defaults.
struct BodyMass {
  float mass = 0;                   ///< kg
  float volume = 0;                 ///< m³
  Vec3 centre{0, 0, 0};             ///< m, of mass, in the geometry's frame
  Vec3 inertia{0, 0, 0};            ///< kg·m², about the principal axes
  Quat principal_axes{0, 0, 0, 1};  ///< rotation from the principal axes to the geometry's frame
};

/// A particle that touches a body, a fixed shape or cloth in the last substep.
struct ParticleContact {
  ParticleId particle = 0;  ///< its id
  BodyId body{};            ///< valid if it touches a body
  ShapeId shape{};          ///< valid if it touches a fixed shape
  ClothId cloth{};          ///< valid if it touches cloth
  Vec3 point{0, 0, 0};      ///< m, on the surface
  Vec3 normal{0, 0, 0};     ///< unit, out of the solid, or off the cloth
  Vec3 impulse{0, 0, 0};    ///< N·s, on the particle; the other side gets the opposite
};

/// Two solids that touch or are about to. The first is always a body.
struct SolidContact {
  BodyId a{};            ///< the first
  BodyId b{};            ///< valid if the second is a body
  ShapeId shape{};       ///< valid if the second is a fixed shape
  Vec3 point{0, 0, 0};   ///< m, on b
  Vec3 normal{0, 0, 0};  ///< unit, from b to a
  float distance = 0;    ///< m, negative if they overlap
  float impulse = 0;     ///< N·s along the normal, in the last step of Bullet
};

/// Two solids that began or ceased to touch in the last step. At least one is a body.
struct ContactEvent {
  BodyId a{};         ///< the first
  BodyId b{};         ///< valid if the second is a body
  ShapeId shape{};    ///< valid if the second is a fixed shape
  bool began = true;  ///< else they ceased to touch
};

/// A body that fell asleep or woke since the end of the step before. A call that wakes a body counts.
struct SleepEvent {
  BodyId body{};      ///< the body
  bool awake = true;  ///< whether it woke; else it fell asleep
};

}  // namespace meniscus
