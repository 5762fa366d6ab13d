// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Bodies and joints.
#pragma once

#include <meniscus/bodies.h>
#include <meniscus/motion.h>

#include <limits>
#include <optional>
#include <vector>

#include "pbd/math/vec.h"
#include "sdk/fields/keyframes.h"
#include "sdk/fields/names.h"
#include "sdk/fields/shapes.h"

namespace meniscus {

constexpr auto names_of(BodyMotion) {
  return std::array{Named{"dynamic", BodyMotion::dynamic}, Named{"kinematic", BodyMotion::kinematic}};
}

template <class V>
void fields(V& v, Keyframe& d) {
  v("time", d.time, required(not_negative), "s", "when, from the start of the run");
  flat(v, "pose", d.pose);
}

template <class V>
void fields(V& v, MotionFile& d) {
  v("file", d.file, required(any_value), "",
    "from the scene's folder: .usda, or lines of time, position and quaternion in .csv, .tum or .txt");
  v("prim", d.prim, any_value, "", "of a .usda: path of the prim; left out, the only one with time samples");
  v("start", d.start, any_value, "s", "added to the times of the file");
  v("scale", d.scale, positive, "m", "length of a unit; of a .usda a factor to its metersPerUnit");
  v("pose", d.pose, any_value, "", "placement of the file's frame in the world");
}

/// What a body may be.
struct BodyGeometry {
  Geometry& geometry;
};

template <class V>
void choices(V& v, BodyGeometry& g) {
  solid_choices(v, g.geometry);
  v.choice("compound", CompoundGeometry{}, g.geometry, "several solids as one");
  v.choice("container", ContainerGeometry{}, g.geometry,
           "a box seen from inside, of a kinematic body: its faces hold the fluid in");
}

/// All but the check of the keyframes, which a scene may take from a file.
template <class V>
void body_fields(V& v, BodyDef& d) {
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
  flat(v, "surface", d.surface);
  flat(v, "filter", d.filter);
  v("linear_damping", d.linear_damping, between(0, 1), "", "share of the velocity lost in a second");
  v("angular_damping", d.angular_damping, between(0, 1), "",
    "share of the angular velocity lost in a second");
  v("can_sleep", d.can_sleep, any_value, "",
    "at rest it is left out of the simulation until something pushes it");
  v("keyframes", d.keyframes, any_value, "", "of a kinematic body: where it is, in the order of the times");
  v("loop", d.loop, any_value, "", "after the last keyframe the first follows; else the body stays there");

  v.check(d.surface.belt_velocity == Vec3{0, 0, 0}, "belt_velocity is for fixed shapes alone");
  const bool kinematic = d.motion == BodyMotion::kinematic;
  const auto at_rest = [](Vec3 velocity) { return velocity == Vec3{0, 0, 0}; };
  v.check(kinematic || !std::holds_alternative<ContainerGeometry>(d.geometry),
          "a container must be kinematic", "geometry");
  for (const auto& [name, velocity] :
       {std::pair{"velocity", d.velocity}, {"angular_velocity", d.angular_velocity}})
    v.check(!kinematic || at_rest(velocity), "velocity and angular_velocity are for dynamic bodies alone",
            name, velocity);
  v.check(kinematic || d.keyframes.empty(), "keyframes are for kinematic bodies alone", "keyframes",
          d.keyframes);
}

template <class V>
void fields(V& v, BodyDef& d) {
  body_fields(v, d);
  check_keyframes(v, d.keyframes, d.loop);
}

// ---- joints ----

template <class V>
void check_limits(V& v, const std::optional<float>& lower, const std::optional<float>& upper) {
  v.check(lower.has_value() == upper.has_value(), "lower and upper must come together");
  v.check(!lower || !upper || *lower <= *upper, "lower must not be above upper", "lower", lower);
}

template <class V>
void fields(V&, FixedJoint&) {}

template <class V>
void fields(V&, BallJoint&) {}

template <class V>
void fields(V& v, HingeJoint& d) {
  constexpr FieldRule half_a_turn = degrees(between(-180, 180));
  v("lower", d.lower, half_a_turn, "degrees", "least angle, from the placement at the start");
  v("upper", d.upper, half_a_turn, "degrees", "greatest angle");
  v("motor_speed", d.motor_speed, any_value, "rad/s", "at which the motor turns b about a");
  v("motor_torque", d.motor_torque, not_negative, "N·m", "the most that the motor gives; 0 is no motor");
  check_limits(v, d.lower, d.upper);
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
  v("stiffness", d.stiffness, or_infinity(not_negative), "N/m", "along each axis of the frame; 0 is free");
  v("damping", d.damping, not_negative, "N·s/m", "along each axis");
  v("held", held, key_only(any_value), "", "axes along which nothing moves, whatever their stiffness");
  v("angular_stiffness", d.angular_stiffness, or_infinity(not_negative), "N·m/rad",
    "about each axis; 0 is free");
  v("angular_damping", d.angular_damping, not_negative, "N·m·s/rad", "about each axis");
  v("angular_held", angular_held, key_only(any_value), "",
    "axes about which nothing turns, whatever their stiffness");
  hold(held, d.stiffness);
  hold(angular_held, d.angular_stiffness);
}

/// Of a joint of one kind, or of any. `names` has the names of the bodies, or their ids.
template <class V, class Names, class Kind>
void joint_fields(V& v, JointDef& d, Names& names, Kind& kind) {
  v("name", d.name, required(not_empty), "", "what messages call this joint");
  v("a", names.a, required(not_empty), "", "name of a body");
  v("b", names.b, any_value, "", "name of another; left out, the world");
  v("frame", d.frame, any_value, "", "placement of the joint in the world, at the start");
  flat(v, "kind", kind);
  v("bodies_collide", d.bodies_collide, any_value, "", "whether a and b still collide with one another");
  v.check(names.a != names.b, "a and b must differ", "b");
}

/// The kinds of joints; `As` is what a kind is read as.
template <template <class> class As, class V, class Whole>
void joint_choices(V& v, Whole& joint) {
  v.choice("fixed", As<FixedJoint>{}, joint, "holds the two frames together");
  v.choice("hinge", As<HingeJoint>{}, joint, "turns about the frame's y axis");
  v.choice("slider", As<SliderJoint>{}, joint, "slides along the frame's y axis");
  v.choice("ball", As<BallJoint>{}, joint, "turns freely about the frame's origin");
  v.choice("spring", As<SpringJoint>{}, joint, "springs towards the placement at the start");
}

template <class V>
void choices(V& v, JointKind& kind) {
  joint_choices<std::type_identity_t>(v, kind);
}

template <class V>
void fields(V& v, JointDef& d) {
  joint_fields(v, d, d, d.kind);
}

}  // namespace meniscus
