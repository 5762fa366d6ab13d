// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Checks of definitions of shapes, bodies and joints.
#include <bitset>
#include <cmath>

#include "pbd/math/vec.h"
#include "sdk/world/check/check.h"

namespace meniscus::check {

namespace {

struct CheckGeometry {
  void operator()(const PlaneGeometry& g) const {
    direction("PlaneGeometry::normal", g.normal);
    finite("PlaneGeometry::offset", g.offset);
  }
  void operator()(const BoxGeometry& g) const { extents("BoxGeometry::half_extents", g.half_extents); }
  void operator()(const ContainerGeometry& g) const {
    extents("ContainerGeometry::half_extents", g.half_extents);
    std::bitset<6> missing;
    for (const Opening& o : g.openings) {
      one_of("Opening::face", o.face, Face::z_high);
      if (o.region)
        box("Opening::region", *o.region);
      else
        missing.set(static_cast<size_t>(o.face));
    }
    if (missing.all()) refuse("ContainerGeometry::openings", "all six faces", "such that a face is left");
  }
  void operator()(const SphereGeometry& g) const { positive("SphereGeometry::radius", g.radius); }
  void operator()(const CapsuleGeometry& g) const {
    positive("CapsuleGeometry::radius", g.radius);
    not_negative("CapsuleGeometry::half_height", g.half_height);
  }
  void operator()(const CylinderGeometry& g) const {
    positive("CylinderGeometry::radius", g.radius);
    positive("CylinderGeometry::half_height", g.half_height);
  }
  void operator()(const MeshGeometry& g) const {
    positive("MeshGeometry::scale", g.scale);
    not_negative("MeshGeometry::cell_size", g.cell_size);
    not_negative("MeshGeometry::max_error", g.max_error);
  }
  void operator()(const HeightFieldGeometry& g) const {
    between("HeightFieldGeometry::columns", g.columns, 2, 1 << 15);
    between("HeightFieldGeometry::rows", g.rows, 2, 1 << 15);
    positive("HeightFieldGeometry::cell_size", g.cell_size);
    const size_t wanted = size_t(g.columns) * size_t(g.rows);
    if (g.heights.size() != wanted) {
      refuse("HeightFieldGeometry::heights", std::to_string(g.heights.size()) + " values",
             "columns · rows = " + std::to_string(wanted));
    }
    for (float height : g.heights) finite("HeightFieldGeometry::heights", height);
  }
  void operator()(const HullGeometry& g) const {
    for (Vec3 p : g.points) finite("HullGeometry::points", p);
    if (g.points.size() < 4) {
      refuse("HullGeometry::points", std::to_string(g.points.size()) + " points", "4 or more");
    }
  }
  void operator()(const CompoundGeometry& g) const {
    if (g.parts.empty()) refuse("CompoundGeometry::parts", "empty", "1 part or more");
    for (const CompoundPart& part : g.parts) {
      pose("CompoundPart::pose", part.pose);
      if (!may_be_part(part.geometry)) {
        refuse("CompoundPart::geometry", "a plane, a container, a height field or a compound",
               "a box, a sphere, a capsule, a cylinder, a mesh or a hull");
      }
      std::visit(*this, part.geometry);
    }
  }

  static bool may_be_part(const Geometry& g) {
    return !std::holds_alternative<PlaneGeometry>(g) && !std::holds_alternative<ContainerGeometry>(g) &&
           !std::holds_alternative<HeightFieldGeometry>(g) && !std::holds_alternative<CompoundGeometry>(g);
  }

  static void extents(const char* name, Vec3 v) {
    finite(name, v);
    if (!(v.x > 0 && v.y > 0 && v.z > 0)) refuse(name, text_of(v), "> 0 on each axis");
  }
};

void surface(const SurfaceDef& def) {
  not_negative("SurfaceDef::friction", def.friction);
  between("SurfaceDef::restitution", def.restitution, 0.0f, 1.0f);
  not_negative("SurfaceDef::adhesion", def.adhesion);
  not_negative("SurfaceDef::solid_friction", def.solid_friction);
  between("SurfaceDef::solid_restitution", def.solid_restitution, 0.0f, 1.0f);
}

void keyframes(const BodyDef& def) {
  if (def.keyframes.empty()) return;
  if (def.motion != BodyMotion::kinematic) {
    refuse("BodyDef::keyframes", std::to_string(def.keyframes.size()) + " keyframes",
           "empty for a body that is not kinematic");
  }
  float last = -1;
  for (const Keyframe& key : def.keyframes) {
    not_negative("Keyframe::time", key.time);
    pose("Keyframe::pose", key.pose);
    if (!(key.time > last)) {
      refuse("Keyframe::time", std::to_string(key.time),
             "above that of the keyframe before, " + std::to_string(last));
    }
    last = key.time;
  }
}

/// A kinematic body has the velocity of its keyframes.
void at_rest(const char* name, Vec3 v) {
  if (!(v == Vec3{0, 0, 0})) refuse(name, text_of(v), "0 for a body that is kinematic");
}

/// Infinite stiffness holds an axis.
void stiffness(const char* name, Vec3 v) {
  if (!(v.x >= 0 && v.y >= 0 && v.z >= 0)) refuse(name, text_of(v), "≥ 0 on each axis");
}

void damping(const char* name, Vec3 v) {
  finite(name, v);
  stiffness(name, v);
}

void limits(const char* name, const std::optional<float>& lower, const std::optional<float>& upper,
            float most) {
  if (lower.has_value() != upper.has_value()) refuse(name, "half given", "given with both ends or none");
  if (!lower) return;
  between(name, *lower, -most, most);
  between(name, *upper, *lower, most);
}

struct CheckJoint {
  void operator()(const FixedJoint&) const {}
  void operator()(const BallJoint&) const {}
  void operator()(const HingeJoint& j) const {
    limits("HingeJoint's limit", j.lower, j.upper, 3.1415927f);
    finite("HingeJoint::motor_speed", j.motor_speed);
    not_negative("HingeJoint::motor_torque", j.motor_torque);
  }
  void operator()(const SliderJoint& j) const {
    limits("SliderJoint's limit", j.lower, j.upper, 1e6f);
    finite("SliderJoint::motor_speed", j.motor_speed);
    not_negative("SliderJoint::motor_force", j.motor_force);
  }
  void operator()(const SpringJoint& j) const {
    stiffness("SpringJoint::stiffness", j.stiffness);
    damping("SpringJoint::damping", j.damping);
    stiffness("SpringJoint::angular_stiffness", j.angular_stiffness);
    damping("SpringJoint::angular_damping", j.angular_damping);
  }
};

}  // namespace

void shape(const ShapeDef& def) {
  pose("ShapeDef::pose", def.pose);
  surface(def.surface);
  std::visit(CheckGeometry{}, def.geometry);
}

void body(const BodyDef& def) {
  one_of("BodyDef::motion", def.motion, BodyMotion::kinematic);
  pose("BodyDef::pose", def.pose);
  surface(def.surface);
  finite("BodyDef::velocity", def.velocity);
  finite("BodyDef::angular_velocity", def.angular_velocity);
  if (def.motion == BodyMotion::kinematic) {
    at_rest("BodyDef::velocity", def.velocity);
    at_rest("BodyDef::angular_velocity", def.angular_velocity);
  }
  positive("BodyDef::density", def.density);
  if (def.mass) positive("BodyDef::mass", *def.mass);
  between("BodyDef::linear_damping", def.linear_damping, 0.0f, 1.0f);
  between("BodyDef::angular_damping", def.angular_damping, 0.0f, 1.0f);
  keyframes(def);
  std::visit(CheckGeometry{}, def.geometry);
}

void joint(const JointDef& def) {
  pose("JointDef::frame", def.frame);
  std::visit(CheckJoint{}, def.kind);
}

}  // namespace meniscus::check
