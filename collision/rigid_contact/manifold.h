// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Convex parts of solids, and the contact of two of them.
#pragma once

#include <meniscus/types.h>

#include <cstdint>

#include "pbd/math/vec.h"

namespace meniscus::collision {

enum class ConvexKind : uint32_t { box, sphere, capsule, plane, hull, ground };

/// A convex part, or a ground, which is a mesh or a height field. A plane bounds a half-space, with the y
/// axis of its frame as the normal.
struct Convex {
  ConvexKind kind;
  Vec3 size;  ///< m: half extents of a box, or of that around a hull or ground; round parts: radius, half
              ///< height along y
  uint32_t table = 0;  ///< of a hull or a ground: its number (hull.h, ground.h)
  float radius = 0;    ///< m, of the ball around a hull
};

inline constexpr uint32_t most_manifold_points = 4;

struct ManifoldPoint {
  Vec3 position;     ///< m, between the two surfaces
  float distance;    ///< m, along the normal; negative where they overlap
  uint32_t feature;  ///< the same in the next step where the same features touch
};

struct Manifold {
  Vec3 normal{0, 0, 0};  ///< unit, from b to a
  uint32_t count = 0;
  ManifoldPoint points[most_manifold_points];

  MENISCUS_HD void add(Vec3 position, float distance, uint32_t feature) {
    if (count < most_manifold_points) points[count++] = {position, distance, feature};
  }
};

MENISCUS_HD inline float component(Vec3 v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}
MENISCUS_HD inline void set_component(Vec3& v, int axis, float value) {
  (axis == 0 ? v.x : axis == 1 ? v.y : v.z) = value;
}
MENISCUS_HD inline Vec3 unit_axis(int axis) {
  return {axis == 0 ? 1.0f : 0.0f, axis == 1 ? 1.0f : 0.0f, axis == 2 ? 1.0f : 0.0f};
}

MENISCUS_HD inline float least_component(Vec3 v) {
  return pbd::min(v.x, pbd::min(v.y, v.z));
}

/// Whether it has contacts with parts of all sizes, and none with its like.
MENISCUS_HD inline bool is_unbounded(const Convex& part) {
  return part.kind == ConvexKind::plane || part.kind == ConvexKind::ground;
}

/// m: of the ball around the part's origin. Planes and grounds have none.
MENISCUS_HD inline float bounding_radius(const Convex& part) {
  switch (part.kind) {
    case ConvexKind::box:
      return length(part.size);
    case ConvexKind::capsule:
      return part.size.x + part.size.y;
    case ConvexKind::hull:
      return part.radius;
    default:
      return part.size.x;
  }
}

}  // namespace meniscus::collision
