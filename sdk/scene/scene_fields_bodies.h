// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The part of scene_fields.h about what moves: bodies and joints.
#pragma once

#include <meniscus/bodies.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "sdk/scene/scene.h"
#include "sdk/scene/scene_fields_shapes.h"

namespace meniscus {

constexpr auto names_of(BodyMotion) {
  return std::array{Named{"dynamic", BodyMotion::dynamic}, Named{"kinematic", BodyMotion::kinematic}};
}

template <class V>
void fields(V& v, Keyframe& d) {
  v("time", d.time, required(not_negative), "s", "when, from the start of the run");
  fields(v, d.pose);
}

/// Strictly: a body cannot be at two places at once.
inline bool in_order(const std::vector<Keyframe>& keyframes) {
  const auto not_later = [](const Keyframe& a, const Keyframe& b) { return a.time >= b.time; };
  return std::adjacent_find(keyframes.begin(), keyframes.end(), not_later) == keyframes.end();
}

/// What a body may be.
struct BodyGeometry {
  Geometry geometry;
};

template <class V>
void choices(V& v, BodyGeometry& g) {
  solid_choices(v, g.geometry);
  v.choice("compound", CompoundGeometry{}, g.geometry, "several solids as one");
  v.choice("container", ContainerGeometry{}, g.geometry,
           "a box seen from inside, of a kinematic body: its faces hold the fluid in");
}

template <class V>
void fields(V& v, SceneCopies& d) {
  constexpr double most = 100'000;
  v("count", d.count, exactly(3, between(1, most)), "", "how many along x, y and z");
  v("step", d.step, any_value, "m", "from one to the next along x, y and z");
  double all = 1;
  for (const int count : d.count) all *= count;
  v.check(all <= most, "there must be at most 100000 copies");
  const float steps[] = {d.step.x, d.step.y, d.step.z};
  for (size_t axis = 0; axis < 3; ++axis)
    v.check(d.count[axis] <= 1 || steps[axis] != 0, "step must not be 0 along an axis with several");
}

template <class V>
void fields(V& v, SceneBody& body) {
  BodyDef& d = body.def;
  BodyGeometry geometry{d.geometry};
  v("name", d.name, required(not_empty), "", "what joints and outputs call this body");
  v("motion", d.motion, any_value, "",
    "dynamic: moved by forces, contacts and fluid; kinematic: by keyframes, and nothing holds it up");
  v("geometry", geometry, required(any_value), "", "what it is");
  v("pose", d.pose, any_value, "",
    "placement of the geometry at the start; that of the first keyframe, if there is one");
  v("velocity", d.velocity, any_value, "m/s", "of a dynamic body's centre of mass, at the start");
  v("angular_velocity", d.angular_velocity, any_value, "rad/s", "of a dynamic body, at the start");
  v("density", d.density, positive, "kg/m³", "mass, centre of mass and inertia follow from the geometry");
  v("mass", d.mass, positive, "kg", "takes the place of what the density gives");
  surface_fields(v, d.surface);
  filter_fields(v, d.filter);
  v("linear_damping", d.linear_damping, between(0, 1), "", "share of the velocity lost in a second");
  v("angular_damping", d.angular_damping, between(0, 1), "",
    "share of the angular velocity lost in a second");
  v("can_sleep", d.can_sleep, any_value, "",
    "at rest it is left out of the simulation until something pushes it");
  v("keyframes", d.keyframes, any_value, "", "of a kinematic body: where it is, in the order of the times");
  v("loop", d.loop, any_value, "", "after the last keyframe the first follows; else the body stays there");
  v("copies", body.copies, any_value, "",
    "a lattice of equal bodies, this one the first; their names end in _0, _1 and so on");
  d.geometry = geometry.geometry;
  if (!d.keyframes.empty()) d.pose = d.keyframes.front().pose;

  const bool kinematic = d.motion == BodyMotion::kinematic;
  v.check(kinematic || !std::holds_alternative<ContainerGeometry>(d.geometry),
          "a container must be kinematic");
  v.check(!kinematic || (length(d.velocity) == 0 && length(d.angular_velocity) == 0),
          "velocity and angular_velocity are for dynamic bodies alone");
  v.check(kinematic || d.keyframes.empty(), "keyframes are for kinematic bodies alone");
  v.check(in_order(d.keyframes), "the times of keyframes must increase");
  v.check(!d.loop || d.keyframes.size() >= 2, "loop needs at least 2 keyframes");
}

// ---- joints ----

constexpr auto names_of(Axis) {
  return std::array{Named{"x", Axis::x}, Named{"y", Axis::y}, Named{"z", Axis::z}};
}

template <class V>
void check_limits(V& v, const std::optional<float>& lower, const std::optional<float>& upper) {
  v.check(lower.has_value() == upper.has_value(), "lower and upper must come together");
  v.check(!lower || !upper || *lower <= *upper, "lower must not be above upper");
}

template <class V>
void fields(V&, FixedJoint&) {}

template <class V>
void fields(V&, BallJoint&) {}

template <class V>
void fields(V& v, HingeJoint& d) {
  std::optional<float> lower, upper;
  v("lower", lower, between(-180, 180), "degrees", "least angle, from the placement at the start");
  v("upper", upper, between(-180, 180), "degrees", "greatest angle");
  v("motor_speed", d.motor_speed, any_value, "rad/s", "at which the motor turns b about a");
  v("motor_torque", d.motor_torque, not_negative, "N·m", "the most that the motor gives; 0 is no motor");
  check_limits(v, lower, upper);
  constexpr float radians = std::numbers::pi_v<float> / 180;
  if (lower) d.lower = *lower * radians;
  if (upper) d.upper = *upper * radians;
}

template <class V>
void fields(V& v, SliderJoint& d) {
  v("lower", d.lower, between(-1e6, 1e6), "m", "least displacement, from the placement at the start");
  v("upper", d.upper, between(-1e6, 1e6), "m", "greatest displacement");
  v("motor_speed", d.motor_speed, any_value, "m/s", "at which the motor moves b along a");
  v("motor_force", d.motor_force, not_negative, "N", "the most that the motor gives; 0 is no motor");
  check_limits(v, d.lower, d.upper);
}

/// JSON has no infinity: axes along which nothing gives way are named.
inline void hold(const std::vector<Axis>& axes, Vec3& stiffness) {
  float Vec3::*const component[] = {&Vec3::x, &Vec3::y, &Vec3::z};
  for (const Axis axis : axes)
    stiffness.*component[static_cast<int>(axis)] = std::numeric_limits<float>::infinity();
}

template <class V>
void fields(V& v, SpringJoint& d) {
  std::vector<Axis> held, angular_held;
  v("stiffness", d.stiffness, not_negative, "N/m", "along each axis of the frame; 0 is free");
  v("damping", d.damping, not_negative, "N·s/m", "along each axis");
  v("held", held, any_value, "", "axes along which nothing moves, whatever their stiffness");
  v("angular_stiffness", d.angular_stiffness, not_negative, "N·m/rad", "about each axis; 0 is free");
  v("angular_damping", d.angular_damping, not_negative, "N·m·s/rad", "about each axis");
  v("angular_held", angular_held, any_value, "", "axes about which nothing turns, whatever their stiffness");
  hold(held, d.stiffness);
  hold(angular_held, d.angular_stiffness);
}

/// A joint as its kind alone describes it.
template <class Kind>
struct JointOf {
  SceneJoint joint;
  Kind kind;

  operator SceneJoint() const {
    SceneJoint result = joint;
    result.def.kind = kind;
    return result;
  }
};

template <class V, class Kind>
void fields(V& v, JointOf<Kind>& j) {
  v("name", j.joint.def.name, required(not_empty), "", "what messages call this joint");
  v("a", j.joint.a, required(not_empty), "", "name of a body");
  v("b", j.joint.b, any_value, "", "name of another; left out, the world");
  v("frame", j.joint.def.frame, any_value, "", "placement of the joint in the world, at the start");
  fields(v, j.kind);
  v("bodies_collide", j.joint.def.bodies_collide, any_value, "",
    "whether a and b still collide with one another");
  v.check(j.joint.a != j.joint.b, "a and b must differ");
}

template <class V>
void choices(V& v, SceneJoint& j) {
  v.choice("fixed", JointOf<FixedJoint>{}, j, "holds the two frames together");
  v.choice("hinge", JointOf<HingeJoint>{}, j, "turns about the frame's y axis");
  v.choice("slider", JointOf<SliderJoint>{}, j, "slides along the frame's y axis");
  v.choice("ball", JointOf<BallJoint>{}, j, "turns freely about the frame's origin");
  v.choice("spring", JointOf<SpringJoint>{}, j, "springs towards the placement at the start");
}

}  // namespace meniscus
