// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Continuous collision detection for one motion. A motion that would pass through a shape is clamped at the
// time of impact and goes on along the surface. So nothing passes, however thin the shape is, and motion
// along the surface continues.
#pragma once

#include "collision/contact/opening.h"
#include "collision/contact/tuning.h"

namespace meniscus::collision {

/// The first point at which a motion meets a surface.
struct Hit {
  float t = 1;  ///< fraction of the motion
  Vec3 at{0, 0, 0};
  Vec3 normal{0, 1, 0};
  bool found = false;
};

/// Conservative advancement: steps along the motion by the distance to the surface, within which nothing can
/// be met. The motion ends half a particle's radius from the surface, unless it leaves the surface.
/// `end_distance` is the surface's distance from the end of the motion, or less.
MENISCUS_HD inline Hit sweep(const ShapeSet& set, const Shape& shape, const Motion& m, float radius,
                             float end_distance) {
  const Vec3 path = m.to - m.from;
  const float path_length = length(path), touch = shape_tuning::touch * radius;
  float t = 0;
  SurfaceSample s{};
  for (int k = 0; k < shape_tuning::sweep_steps; ++k) {
    s = sample_surface(set, shape, m.from + t * path, path_length + radius);
    // No distance changes by more than the length of the path. If the distances at both ends add up to more,
    // nothing is met.
    if (k == 0 && s.distance + end_distance > path_length + shape_tuning::sweep_margin * touch) return {};
    if (s.distance < touch && dot(s.normal, path) < 0) return {t, m.from + t * path, s.normal, true};
    // A motion that slides along the surface must still advance.
    t += pbd::max(s.distance - shape_tuning::advance * touch, shape_tuning::advance * touch) / path_length;
    if (t >= 1) return {};
  }
  return {t, m.from + t * path, s.normal, true};  // too many steps: the motion stops here
}

/// The surface's distance from the end of the motion, for sweep().
MENISCUS_HD inline float end_distance(const ShapeSet& set, const Shape& shape, const Motion& m,
                                      float radius) {
  return sample_surface(set, shape, m.to, length(m.to - m.from) + radius).distance;
}

/// The same for a plane, from its open side.
MENISCUS_HD inline Hit cross_plane(const ShapeSet& set, const Shape& plane, const Motion& m, float radius) {
  const float before = plane_surface(plane, m.from).distance, after = plane_surface(plane, m.to).distance;
  const float touch = shape_tuning::touch * radius;
  if (before < 0 || after >= touch || after >= before || left_through_opening(set, plane, m, radius))
    return {};
  const float t = before > touch ? (before - touch) / (before - after) : 0;
  return {t, m.from + t * (m.to - m.from), plane_surface(plane, m.from).normal, true};
}

/// Where a motion meets one shape, as that shape sees it.
MENISCUS_HD inline Hit meet(const ShapeSet& set, const Shape& shape, const Motion& m, float radius) {
  // The bounds contain the shape for the whole substep, so a motion away from them needs no test in its
  // frame.
  if (shape.kind != ShapeKind::plane && out_of_reach(shape, m.from, m.to, radius)) return {};
  const Motion beside = motion_beside(shape, m);
  if (shape.kind == ShapeKind::plane) return cross_plane(set, shape, beside, radius);
  if (out_of_reach(shape, beside.from, beside.to, radius)) return {};
  return sweep(set, shape, beside, radius, end_distance(set, shape, beside, radius));
}

}  // namespace meniscus::collision
