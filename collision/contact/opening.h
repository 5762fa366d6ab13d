// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "collision/contact/shape.h"

namespace meniscus::collision {

/// Whether the plane, a wall of a container with openings, has nothing to do with this motion: it starts
/// outside of that container, which is to say that it left through an opening, or it passes through an
/// opening of this one. Outside is beyond a wall with an opening, or further beyond a closed one than a solve
/// lets anything sink in.
MENISCUS_HD inline bool left_through_opening(const ShapeSet& set, const Shape& plane, const Motion& m,
                                             float radius) {
  for (uint32_t k = 0; k < plane.wall_count; k += shapes_at_once) {
    const uint32_t outside_of = which_shapes(plane.first_wall + k, plane.wall_count - k, [&](uint32_t n) {
      const Shape& wall = set.shapes[n];
      return plane_surface(wall, m.from).distance < (wall.opening_count ? 0.0f : -2 * radius);
    });
    if (outside_of) return true;
  }
  if (plane.opening_count == 0) return false;
  const float before = plane_surface(plane, m.from).distance, after = plane_surface(plane, m.to).distance;
  const float t = after < 0 ? before / (before - after) : 1;
  return in_opening(set, plane, m.from + t * (m.to - m.from));
}

}  // namespace meniscus::collision
