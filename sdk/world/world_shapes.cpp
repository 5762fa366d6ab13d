// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "sdk/world/world_shapes.h"

#include <algorithm>
#include <cmath>

#include "collision/mesh.h"

namespace meniscus {

namespace {

using collision::Shape;
using collision::ShapeKind;

/// World box of a local box under a pose.
Aabb world_bounds(const Pose& pose, const Aabb& local) {
  const Vec3 centre = to_world(pose, 0.5f * (local.lower + local.upper));
  const Vec3 half = 0.5f * (local.upper - local.lower);
  const Vec3 x = abs(rotate(pose.rotation, {half.x, 0, 0})), y = abs(rotate(pose.rotation, {0, half.y, 0})),
             z = abs(rotate(pose.rotation, {0, 0, half.z}));
  return {centre - (x + y + z), centre + (x + y + z)};
}

struct MakeParts {
  const ShapeDef& def;
  Engine& engine;
  float spacing, reach;

  Shape base(ShapeKind kind, Vec3 size, Vec3 half) const {
    Shape s;
    s.kind = kind;
    s.pose = def.pose;
    s.size = size;
    s.friction = def.friction;
    s.restitution = def.restitution;
    s.bounds = world_bounds(def.pose, {-half, half});
    return s;
  }

  Shape plane(Vec3 local_normal, float local_offset) const {
    const Vec3 normal = rotate(def.pose.rotation, local_normal);
    Shape s = base(ShapeKind::plane, normal, {0, 0, 0});
    s.offset = local_offset + dot(normal, def.pose.position);
    return s;
  }

  ShapeParts operator()(const PlaneGeometry& g) const {
    const float l = length(g.normal);
    return {{plane(g.normal / l, g.offset / l)}, {}};
  }
  ShapeParts operator()(const BoxGeometry& g) const {
    return {{base(ShapeKind::box, g.half_extents, g.half_extents)}, {}};
  }
  ShapeParts operator()(const SphereGeometry& g) const {
    return {{base(ShapeKind::sphere, {g.radius, 0, 0}, {g.radius, g.radius, g.radius})}, {}};
  }
  ShapeParts operator()(const CapsuleGeometry& g) const {
    return {{base(ShapeKind::capsule, {g.radius, g.half_height, 0},
                  {g.radius, g.radius + g.half_height, g.radius})},
            {}};
  }
  ShapeParts operator()(const CylinderGeometry& g) const {
    return {{base(ShapeKind::cylinder, {g.radius, g.half_height, 0}, {g.radius, g.half_height, g.radius})},
            {}};
  }
  ShapeParts operator()(const MeshGeometry& g) const {
    const collision::TriangleMesh mesh = collision::load_mesh(g.file, g.scale);
    Shape s = base(ShapeKind::sdf, {0, 0, 0}, {0, 0, 0});
    s.table = engine.add_sdf(mesh, g.cell_size > 0 ? g.cell_size : 0.5f * spacing, reach);
    s.bounds = world_bounds(def.pose, collision::bounds(mesh));
    return {{s}, {}};
  }
  ShapeParts operator()(const HeightFieldGeometry& g) const {
    Shape s = base(ShapeKind::height_field, {0, 0, 0}, {0, 0, 0});
    s.table = engine.add_height_field(static_cast<uint32_t>(g.columns), static_cast<uint32_t>(g.rows),
                                      g.cell_size, g.heights);
    const float x = 0.5f * g.cell_size * static_cast<float>(g.columns - 1);
    const float z = 0.5f * g.cell_size * static_cast<float>(g.rows - 1);
    const float top = *std::max_element(g.heights.begin(), g.heights.end());
    // Solid all the way down: the box reaches as far as a particle could fall in a lifetime of steps.
    s.bounds = world_bounds(def.pose, {{-x, -1e6f, -z}, {x, top, z}});
    return {{s}, {}};
  }

  ShapeParts operator()(const ContainerGeometry& g) const {
    ShapeParts parts;
    const float half[3] = {g.half_extents.x, g.half_extents.y, g.half_extents.z};
    for (int face = 0; face < 6; ++face) {
      const int axis = face / 2;
      const float inwards = face % 2 == 0 ? 1.0f : -1.0f;
      const Vec3 normal{axis == 0 ? inwards : 0, axis == 1 ? inwards : 0, axis == 2 ? inwards : 0};
      Shape wall = plane(normal, -half[axis]);
      wall.first_opening = static_cast<uint32_t>(parts.openings.size());
      bool open = false;
      for (const Opening& o : g.openings) {
        if (static_cast<int>(o.face) != face) continue;
        if (!o.region)
          open = true;
        else
          parts.openings.push_back({without_depth(*o.region, axis)});
      }
      wall.opening_count = static_cast<uint32_t>(parts.openings.size()) - wall.first_opening;
      if (!open) parts.shapes.push_back(wall);
    }
    return parts;
  }

  static Aabb without_depth(Aabb box, int axis) {
    constexpr float everywhere = 1e30f;
    (axis == 0 ? box.lower.x : axis == 1 ? box.lower.y : box.lower.z) = -everywhere;
    (axis == 0 ? box.upper.x : axis == 1 ? box.upper.y : box.upper.z) = everywhere;
    return box;
  }
};

}  // namespace

ShapeParts make_shape_parts(const ShapeDef& def, Engine& engine, float spacing, float reach) {
  return std::visit(MakeParts{def, engine, spacing, reach}, def.geometry);
}

}  // namespace meniscus
