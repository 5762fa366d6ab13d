// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "collision/shape.h"

namespace meniscus::collision {

/// A particle's motion over a substep.
struct Motion {
  Vec3 from, to;  ///< m
};

/// Where a particle meets a shape.
struct FoundContact {
  ShapeSample sample;
  Vec3 point;  ///< m, on the surface
  bool found;  ///< near enough to have images (fluid/images.h)
};

/// Whether the plane, a wall of a container with openings, has nothing to do with this motion: it starts
/// beyond a wall of that container, which is to say that it left through an opening, or it passes through an
/// opening of this one.
MENISCUS_HD inline bool left_through_opening(const ShapeSet& set, const Shape& plane, const Motion& m) {
  for (uint32_t k = plane.first_wall; k < plane.first_wall + plane.wall_count; ++k) {
    const Shape& wall = set.shapes[k];
    if (wall.opening_count && plane_surface(wall, m.from).distance < 0) return true;
  }
  if (plane.opening_count == 0) return false;
  const float before = plane_surface(plane, m.from).distance, after = plane_surface(plane, m.to).distance;
  const float t = after < 0 ? before / (before - after) : 1;
  return in_opening(set, plane, m.from + t * (m.to - m.from));
}

/// Looks for the contact of one particle with a plane.
MENISCUS_HD inline FoundContact find_plane_contact(const ShapeSet& set, const Shape& plane, const Motion& m,
                                                   float radius, float h) {
  const SurfaceSample s = plane_surface(plane, m.to);
  // Images end where what touches the surface is a support radius away.
  const bool near = s.distance < h - radius;
  return {{s}, m.to - s.distance * s.normal, near && !left_through_opening(set, plane, m)};
}

/// Looks for the contact of one particle with one shape, where the motion ends.
MENISCUS_HD inline FoundContact find_contact(const ShapeSet& set, const Shape& shape, const Motion& m,
                                             float radius, float h) {
  if (shape.kind == ShapeKind::plane) return find_plane_contact(set, shape, m, radius, h);
  if (out_of_reach(shape, m.to, m.to, h)) return {{{h, {0, 1, 0}}}, m.to, false};
  const ShapeSample sample = sample_shape(set, shape, m.to, h);
  return {sample, m.to - sample.surface.distance * sample.surface.normal,
          sample.surface.distance < h - radius};
}

}  // namespace meniscus::collision
