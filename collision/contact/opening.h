// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests whether a particle has left a container through an aperture.
#pragma once

#include "collision/contact/shape.h"
#include "collision/contact/tuning.h"

namespace meniscus::collision {

/// Whether a plane, a wall of a container with apertures, ignores this motion. It does if the motion starts
/// outside the container, because the particle then left through an aperture. It also does if the motion
/// passes through an aperture of this wall. Outside means beyond a wall with an aperture. For a closed wall
/// it means further beyond than particles sink in during a solve.
MENISCUS_HD inline bool left_through_opening(const ShapeSet& set, const Shape& plane, const Motion& m,
                                             float radius) {
  for (uint32_t k = 0; k < plane.wall_count; k += shapes_at_once) {
    const uint32_t outside_of = which_shapes(plane.first_wall + k, plane.wall_count - k, [&](uint32_t n) {
      const Shape& wall = set.shapes[n];
      return plane_surface(wall, m.from).distance <
             (wall.opening_count ? 0.0f : shape_tuning::outside_depth * radius);
    });
    if (outside_of) return true;
  }
  if (plane.opening_count == 0) return false;
  const float before = plane_surface(plane, m.from).distance, after = plane_surface(plane, m.to).distance;
  const float t = after < 0 ? before / (before - after) : 1;
  return in_opening(set, plane, m.from + t * (m.to - m.from));
}

}  // namespace meniscus::collision
