// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Finds the contact of one particle, or of one point of a face, with one shape.
#pragma once

#include "collision/contact/sweep.h"
#include "collision/contact/tuning.h"

namespace meniscus::collision {

/// Where a particle meets a shape.
struct FoundContact {
  SurfaceSample surface;  ///< as seen from `at`
  Vec3 at;                ///< m
  bool found;             ///< near enough to have mirror ghosts (fluid/kernel/mirror_ghosts.h)
};

MENISCUS_HD inline FoundContact no_contact() {
  return {{0, {0, 1, 0}}, {0, 0, 0}, false};
}

/// Finds the contact of one particle with a plane.
MENISCUS_HD inline FoundContact find_plane_contact(const ShapeSet& set, const Shape& plane, const Motion& m,
                                                   float radius, float h) {
  const SurfaceSample s = plane_surface(plane, m.to);
  // Mirror ghosts end where a particle that touches the surface is a support radius away.
  const bool near = s.distance < h - radius;
  return {s, m.to, near && !left_through_opening(set, plane, m, radius)};
}

/// Finds the contact of one particle with one shape at the end of the motion. With a moving shape the contact
/// is where the two met during the motion. Then it holds the particle on its own side, and both share the
/// impulse.
MENISCUS_HD inline FoundContact find_contact(const ShapeSet& set, const Shape& shape, const Motion& m,
                                             float radius, float h) {
  if (shape.kind == ShapeKind::plane) return find_plane_contact(set, shape, m, radius, h);
  const bool moves = shape.body != pbd::no_index;
  if (out_of_reach(shape, moves ? m.from : m.to, m.to, h)) return no_contact();
  const SurfaceSample surface = sample_surface(set, shape, m.to, h);
  if (moves && squared_length(m.to - m.from) > radius * radius) {
    const Hit hit = sweep(set, shape, m, radius, surface.distance);
    if (hit.found) return {sample_surface(set, shape, hit.at, h), hit.at, true};
  }
  return {surface, m.to, surface.distance < h - radius};
}

/// The same for a point of a face. No sweep has clamped its motion, so it may have passed through fixed
/// shapes as well. Where it ends inside a solid, its motion tells the side that it came from.
MENISCUS_HD inline FoundContact find_face_contact(const ShapeSet& set, const Shape& shape, const Motion& m,
                                                  float radius, float h) {
  if (shape.kind == ShapeKind::plane) return find_plane_contact(set, shape, m, radius, h);
  if (out_of_reach(shape, m.from, m.to, h)) return no_contact();
  const SurfaceSample surface = sample_surface(set, shape, m.to, h);
  if (surface.distance < shape_tuning::touch * radius || squared_length(m.to - m.from) > radius * radius) {
    const Hit hit = sweep(set, shape, m, radius, surface.distance);
    if (hit.found) return {sample_surface(set, shape, hit.at, h), hit.at, true};
  }
  return {surface, m.to, surface.distance < h - radius};
}

}  // namespace meniscus::collision
