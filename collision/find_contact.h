// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "collision/shape.h"
#include "pbd/contacts.h"

namespace meniscus::collision {

/// A particle's motion over a substep.
struct Motion {
  Vec3 from, to;  ///< m
};

namespace detail {

/// Conservative advancement: steps along the motion by the distance to the surface, which nothing can cut
/// short. Returns the sample where the motion meets the surface, or the one at its end with `hit` false.
struct Sweep {
  SurfaceSample surface;
  Vec3 at;
  bool hit;
};

MENISCUS_HD inline Sweep sweep(const ShapeSet& set, const Shape& shape, const Motion& m, float radius,
                               float reach) {
  constexpr int most_steps = 48;
  const Vec3 path = m.to - m.from;
  const float path_length = length(path);
  const float touch = 0.5f * radius;
  float t = 0;
  for (int k = 0; k < most_steps; ++k) {
    const Vec3 at = m.from + t * path;
    const SurfaceSample s = sample_surface(set, shape, at, reach);
    if (s.distance < touch && dot(s.normal, path) < 0) return {s, at, true};
    // A particle that slides along the surface, or leaves it, still has to get on.
    t += pbd::max(s.distance - 0.5f * touch, 0.5f * touch) / path_length;
    if (t >= 1) break;
  }
  return {sample_surface(set, shape, m.to, reach), m.to, false};
}

MENISCUS_HD inline bool out_of_reach(const Shape& shape, const Motion& m, float reach) {
  if (shape.kind == ShapeKind::plane) return false;
  const Vec3 lower = min(m.from, m.to), upper = max(m.from, m.to);
  const Aabb& b = shape.bounds;
  return lower.x > b.upper.x + reach || lower.y > b.upper.y + reach || lower.z > b.upper.z + reach ||
         upper.x < b.lower.x - reach || upper.y < b.lower.y - reach || upper.z < b.lower.z - reach;
}

}  // namespace detail

/// Where a moving particle meets a shape.
struct FoundContact {
  ShapeSample sample;
  Vec3 point;  ///< m, on the surface
  bool found;  ///< nearer than the support radius, or met on the way
};

/// Looks for the contact of one particle with one shape. A particle that moves further than `radius` is
/// swept, so that it does not pass through anything thin.
MENISCUS_HD inline FoundContact find_contact(const ShapeSet& set, const Shape& shape, const Motion& m,
                                             float radius, float h) {
  FoundContact none{{{h, {0, 1, 0}}}, m.to, false};
  if (detail::out_of_reach(shape, m, h)) return none;
  const Vec3 path = m.to - m.from;
  if (shape.kind != ShapeKind::plane && dot(path, path) > radius * radius) {
    const detail::Sweep s = detail::sweep(set, shape, m, radius, h);
    if (s.hit) {
      ShapeSample sample = sample_shape(set, shape, s.at, h);
      return {sample, s.at - s.surface.distance * s.surface.normal, true};
    }
  }
  const ShapeSample sample = sample_shape(set, shape, m.to, h);
  if (sample.surface.distance >= h) return none;
  if (shape.opening_count) {
    // Beyond a wall with a hole in it there are only particles that went through the hole.
    const float before = sample_surface(set, shape, m.from, h).distance;
    if (before < 0 || in_opening(set, shape, m.to)) return none;
  }
  return {sample, m.to - sample.surface.distance * sample.surface.normal, true};
}

}  // namespace meniscus::collision
