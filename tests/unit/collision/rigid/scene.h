// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Rigid worlds for tests.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <vector>

#include "collision/mesh/hull.h"
#include "collision/rigid/rigid_world.h"
#include "pbd/math/vec.h"
#include "tests/unit/collision/mesh_shapes.h"

namespace meniscus::collision {

using Kind = RigidPart::Kind;

inline const Quat no_turn{0, 0, 0, 1};

inline Quat about(Vec3 axis, float angle) {
  return rotation_by(angle * axis);
}

inline RigidPart box_part(Vec3 half) {
  return {.kind = Kind::box, .size = half};
}
inline RigidPart round_part(Kind kind, float radius, float half_height = 0) {
  return {.kind = kind, .size = {radius, half_height, 0}};
}
inline RigidPart mesh_part(Kind kind, TriangleMesh mesh) {
  return {.kind = kind, .mesh = std::make_shared<const TriangleMesh>(std::move(mesh))};
}
inline RigidPart plane_part(Vec3 normal = {0, 1, 0}, float offset = 0) {
  return {.kind = Kind::plane, .size = normal, .offset = offset};
}

inline MassProperties mass_of(const RigidPart& part, double density) {
  switch (part.kind) {
    case Kind::box:
      return box_mass(part.size, density);
    case Kind::sphere:
      return sphere_mass(part.size.x, density);
    case Kind::capsule:
      return capsule_mass(part.size.x, part.size.y, density);
    case Kind::cylinder:
      return cylinder_mass(part.size.x, part.size.y, density);
    default:
      return mesh_mass(*part.mesh, density);
  }
}

inline RigidBodyDef body_def(std::vector<RigidPart> parts, const Pose& pose, double density = 1000) {
  std::vector<PlacedMass> masses;
  for (const RigidPart& part : parts) masses.push_back({mass_of(part, density), part.pose});
  RigidBodyDef def;
  def.mass = combine(masses);
  def.solid.parts = std::move(parts);
  def.solid.pose = pose;
  return def;
}
inline RigidBodyDef body_def(const RigidPart& part, Vec3 position, double density = 1000) {
  return body_def(std::vector{part}, Pose{position, no_turn}, density);
}

inline RigidBodyDef kinematic_def(std::vector<RigidPart> parts, const Pose& pose) {
  RigidBodyDef def;
  def.motion = BodyMotion::kinematic;
  def.solid.parts = std::move(parts);
  def.solid.pose = pose;
  return def;
}

inline RigidSolid fixed_solid(const RigidPart& part, const Pose& pose = {}) {
  RigidSolid solid;
  solid.parts = {part};
  solid.pose = pose;
  return solid;
}

inline void run(RigidWorld& world, float dt, int steps) {
  for (int i = 0; i < steps; ++i) world.step(dt, {});
}

/// FNV-1a over all poses, velocities and states of sleep.
inline uint64_t hash_of(const RigidWorld& world) {
  uint64_t hash = 14695981039346656037u;
  const auto add = [&hash](const void* data, size_t size) {
    for (size_t i = 0; i < size; ++i) {
      hash = (hash ^ static_cast<const unsigned char*>(data)[i]) * 1099511628211u;
    }
  };
  for (uint32_t body = 0; body < world.body_slots(); ++body) {
    const Pose pose = world.pose(body);
    const Vec3 v = world.velocity(body), w = world.angular_velocity(body);
    const bool awake = world.awake(body);
    add(&pose, sizeof pose);
    add(&v, sizeof v);
    add(&w, sizeof w);
    add(&awake, sizeof awake);
  }
  return hash;
}

}  // namespace meniscus::collision
