// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Clamps the motion of a particle at the shapes that it would pass through.
#pragma once

#include "collision/contact/sweep.h"
#include "collision/contact/tuning.h"

namespace meniscus::collision {

MENISCUS_HD inline Hit first_fixed_hit(const ShapeSet& set, const Motion& m, float radius, bool planes_too,
                                       const CollisionFilter& filter) {
  Hit first;
  for (uint32_t k = 0; k < set.fixed; ++k) {
    const Shape& shape = set.shapes[k];
    if (!collide(shape, filter)) continue;
    Hit hit;
    if (shape.kind == ShapeKind::plane) {
      if (planes_too) hit = cross_plane(set, shape, m, radius);
    } else if (!out_of_reach(shape, m.from, m.to, radius)) {
      hit = sweep(set, shape, m, radius, end_distance(set, shape, m, radius));
    }
    if (hit.found && hit.t <= first.t) first = hit;
  }
  return first;
}

/// The rest of the motion after a hit, without its component into the surface.
MENISCUS_HD inline Vec3 slide(const Hit& hit, Vec3 to) {
  const Vec3 rest = to - hit.at;
  return hit.at + rest - pbd::min(0.0f, dot(rest, hit.normal)) * hit.normal;
}

/// Where the motion ends if it passes through no fixed shape. Half-spaces count only with `planes_too`: the
/// contact search sees a half-space from behind as well.
MENISCUS_HD inline Vec3 limit_by_fixed(const ShapeSet& set, Motion m, float radius, bool planes_too,
                                       const CollisionFilter& filter) {
  for (int k = 0; k < shape_tuning::fixed_hits; ++k) {
    const Vec3 path = m.to - m.from;
    if (dot(path, path) < shape_tuning::no_motion2 * radius * radius) return m.to;
    const Hit hit = first_fixed_hit(set, m, radius, planes_too, filter);
    if (!hit.found) return m.to;
    m = {hit.at, slide(hit, m.to)};
  }
  return m.from;  // too many hits: the motion stops at the last one
}

/// Where the motion ends if it passes through no moving shape. Each shape sees the motion in its own frame,
/// so after a hit the whole motion is tested again. If there is no way out, the particle moves along with the
/// last shape that it met. Shapes count that the particle may meet, by meets(shape).
template <class Candidates, class Meets>
MENISCUS_HD Vec3 limit_by_moving(const ShapeSet& set, const Candidates& candidates, uint32_t i, Motion m,
                                 float radius, const Meets& meets) {
  Vec3 carried = m.to;
  for (int k = 0; k < shape_tuning::moving_hits; ++k) {
    Hit first;
    candidates.for_each_near(set, i, m, radius, [&](uint32_t number) {
      const Shape& shape = set.shapes[number];
      if (number < set.fixed || !meets(shape)) return;
      const Hit hit = meet(set, shape, m, radius);
      if (!hit.found || hit.t > first.t) return;
      first = hit;
      carried = motion_beside(shape, m).from;
    });
    if (!first.found) return m.to;
    m.to = slide(first, m.to);
  }
  return carried;
}

}  // namespace meniscus::collision
