// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "collision/sweep.h"

namespace meniscus::collision {

/// Where a particle meets a shape.
struct FoundContact {
  ShapeSample sample;
  Vec3 point;  ///< m, on the surface
  bool found;  ///< near enough to have images (fluid/images.h)
};

/// Looks for the contact of one particle with a plane.
MENISCUS_HD inline FoundContact find_plane_contact(const ShapeSet& set, const Shape& plane, const Motion& m,
                                                   float radius, float h) {
  const SurfaceSample s = plane_surface(plane, m.to);
  // Images end where what touches the surface is a support radius away.
  const bool near = s.distance < h - radius;
  return {{s}, m.to - s.distance * s.normal, near && !left_through_opening(set, plane, m, radius)};
}

MENISCUS_HD inline FoundContact no_contact() {
  return {{{0, {0, 1, 0}}}, {0, 0, 0}, false};
}

/// Looks for the contact of one particle with one shape, where the motion ends. With what moves it is where
/// the two met on the way: so that the contact holds the particle back on its side, and both share the
/// impulse.
MENISCUS_HD inline FoundContact find_contact(const ShapeSet& set, const Shape& shape, const Motion& m,
                                             float radius, float h) {
  if (shape.kind == ShapeKind::plane) return find_plane_contact(set, shape, m, radius, h);
  const bool moves = shape.body != pbd::no_index;
  if (out_of_reach(shape, moves ? m.from : m.to, m.to, h)) return no_contact();
  if (moves && squared_length(m.to - m.from) > radius * radius) {
    const Hit hit = sweep(set, shape, m, radius);
    if (hit.found) {
      const ShapeSample sample = sample_shape(set, shape, hit.at, h);
      return {sample, hit.at - sample.surface.distance * sample.surface.normal, true};
    }
  }
  const ShapeSample sample = sample_shape(set, shape, m.to, h);
  return {sample, m.to - sample.surface.distance * sample.surface.normal,
          sample.surface.distance < h - radius};
}

}  // namespace meniscus::collision
