// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Converts the setups of cloth_solid_bench.h to the inputs of the modules.
#pragma once

#include "cloth/build/cloth_model.h"
#include "tests/bench/harness/cloth_solid_bench.h"

namespace meniscus::tests {

inline Aabb local_bounds(const SolidSetup& solid) {
  const Vec3 s = solid.size;
  switch (solid.kind) {
    case collision::ShapeKind::box:
      return {-s, s};
    case collision::ShapeKind::sdf:
      return collision::bounds(*solid.mesh);
    case collision::ShapeKind::capsule:
      return {{-s.x, -s.x - s.y, -s.x}, {s.x, s.x + s.y, s.x}};
    default:
      return {{-s.x, -s.x, -s.x}, {s.x, s.x, s.x}};
  }
}

inline collision::Shape shape_of(const SolidSetup& solid) {
  collision::Shape shape;
  shape.kind = solid.kind;
  shape.size = solid.size;
  shape.pose = shape.start = solid.pose;
  shape.surface.friction = solid.friction;
  return shape;
}

inline collision::RigidBodyDef body_of(const SolidSetup& solid) {
  using Kind = collision::RigidPart::Kind;
  collision::RigidBodyDef def;
  collision::RigidPart part;
  part.size = solid.size;
  switch (solid.kind) {
    case collision::ShapeKind::box:
      part.kind = Kind::box;
      def.mass = collision::with_mass(collision::box_mass(solid.size, 1), solid.mass);
      break;
    case collision::ShapeKind::capsule:
      part.kind = Kind::capsule;
      def.mass = collision::with_mass(collision::capsule_mass(solid.size.x, solid.size.y, 1), solid.mass);
      break;
    case collision::ShapeKind::sdf:
      part.kind = Kind::mesh;
      part.mesh = std::make_shared<const collision::TriangleMesh>(*solid.mesh);
      break;
    default:
      part.kind = Kind::sphere;
      def.mass = collision::with_mass(collision::sphere_mass(solid.size.x, 1), solid.mass);
  }
  def.solid.parts = {part};
  def.solid.pose = solid.pose;
  const bool falls = solid.motion == SolidSetup::Motion::dynamic;
  def.motion = falls ? BodyMotion::dynamic : BodyMotion::kinematic;
  def.velocity = solid.velocity;
  def.linear_damping = def.angular_damping = solid.damping;
  def.can_sleep = solid.can_sleep;
  def.keyframes = solid.keyframes;
  if (!falls && solid.keyframes.empty()) {
    const Vec3 end = solid.pose.position + 100 * solid.velocity;
    def.keyframes = {{0, solid.pose}, {100, {end, solid.pose.rotation}}};
  }
  return def;
}

inline cloth::ClothModel cloth_model(const ClothSolidSetup& setup) {
  cloth::ClothModel model;
  model.constraints = cloth::build_constraints(setup.mesh, setup.fabric);
  for (const auto& t : setup.mesh.triangles) model.triangles.push_back({t[0], t[1], t[2], 0});
  model.rest = setup.mesh.vertices;
  cloth::Piece piece;
  piece.end_vertex = static_cast<uint32_t>(model.rest.size());
  piece.stretch_damping = piece.bending_damping = setup.damping;
  model.pieces = {piece};
  model.held = setup.held;
  return model;
}

}  // namespace meniscus::tests
