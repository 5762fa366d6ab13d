// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Motion that would pass through a shape is cut short where it meets it, and goes on along the surface:
// nothing gets through, however thin, and what was on the way along the surface gets on.
#pragma once

#include "collision/find_contact.h"

namespace meniscus::collision {

/// The first place at which a motion meets a surface.
struct Hit {
  float t = 1;  ///< of the motion
  Vec3 normal{0, 1, 0};
  bool found = false;
};

/// Conservative advancement: steps along the motion by the distance to the surface, which nothing can cut
/// short. The motion ends half a particle's radius from the surface, unless it leaves.
MENISCUS_HD inline Hit sweep(const ShapeSet& set, const Shape& shape, const Motion& m, float radius) {
  constexpr int most_steps = 256;
  const Vec3 path = m.to - m.from;
  const float path_length = length(path), touch = 0.5f * radius;
  float t = 0;
  SurfaceSample s{};
  for (int k = 0; k < most_steps; ++k) {
    s = sample_surface(set, shape, m.from + t * path, path_length + radius);
    if (s.distance < touch && dot(s.normal, path) < 0) return {t, s.normal, true};
    // What slides along the surface still has to get on.
    t += pbd::max(s.distance - 0.5f * touch, 0.5f * touch) / path_length;
    if (t >= 1) return {};
  }
  return {t, s.normal, true};  // too far to follow: it stops here
}

/// The same for a plane, from its open side.
MENISCUS_HD inline Hit cross_plane(const ShapeSet& set, const Shape& plane, const Motion& m, float radius) {
  const float before = plane_surface(plane, m.from).distance, after = plane_surface(plane, m.to).distance;
  const float touch = 0.5f * radius;
  if (before < 0 || after >= touch || after >= before || left_through_opening(set, plane, m)) return {};
  return {before > touch ? (before - touch) / (before - after) : 0, plane_surface(plane, m.from).normal,
          true};
}

MENISCUS_HD inline Hit first_hit(const ShapeSet& set, const Motion& m, float radius, bool planes_too) {
  Hit first;
  for (uint32_t k = 0; k < set.shapes.count; ++k) {
    const Shape& shape = set.shapes[k];
    Hit hit;
    if (shape.kind == ShapeKind::plane) {
      if (planes_too) hit = cross_plane(set, shape, m, radius);
    } else if (!out_of_reach(shape, m.from, m.to, radius)) {
      hit = sweep(set, shape, m, radius);
    }
    if (hit.found && hit.t <= first.t) first = hit;
  }
  return first;
}

/// Where the motion ends if nothing is passed through. Each hit takes away what is left of the motion into
/// the surface.
MENISCUS_HD inline Vec3 limit_motion(const ShapeSet& set, Motion m, float radius, bool planes_too) {
  constexpr int most_hits = 4;
  for (int k = 0; k < most_hits; ++k) {
    const Vec3 path = m.to - m.from;
    if (dot(path, path) < 1e-6f * radius * radius) return m.to;
    const Hit hit = first_hit(set, m, radius, planes_too);
    if (!hit.found) return m.to;
    const Vec3 at = m.from + hit.t * path;
    const Vec3 rest = (1 - hit.t) * path;
    m = {at, at + rest - pbd::min(0.0f, dot(rest, hit.normal)) * hit.normal};
  }
  return m.from;
}

}  // namespace meniscus::collision
