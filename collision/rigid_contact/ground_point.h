// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Where a point or a ball touches a ground.
#pragma once

#include "collision/rigid_contact/ground.h"
#include "collision/rigid_contact/tuning.h"

namespace meniscus::collision {

/// The point of a triangle that is nearest to p.
struct NearestOnTriangle {
  Vec3 way;       ///< m, from there to p
  float size;     ///< m, its length
  float side;     ///< positive outside
  bool is_local;  ///< no other point near it is nearer to p
  Vec3 normal;    ///< unit, towards the outside, along `way` unless p is on the surface
};

/// A point that is beyond an edge by less than `slack` (m) is over the triangle.
MENISCUS_HD inline NearestOnTriangle nearest_on_triangle(const Triangle& t, const TriangleSeams& s, Vec3 p,
                                                         float slack) {
  const Vec3 corner[3] = {t.a, t.b, t.c};
  const Vec3 n = normalized_or(area_normal(t), {0, 1, 0});
  int edge = -1, vertex = -1;
  Vec3 way = dot(p - t.a, n) * n;
  float least = 1e30f;
  for (int k = 0; k < 3; ++k) {
    const Vec3 a = corner[k], e = corner[k == 2 ? 0 : k + 1] - a;
    if (dot(cross(e, n), p - a) <= slack * length(e)) continue;
    const float along = dot(p - a, e), whole = dot(e, e);
    const Vec3 q = along <= 0 ? a : along < whole ? a + (along / whole) * e : a + e;
    if (dot(p - q, p - q) >= least) continue;
    least = dot(p - q, p - q);
    way = p - q;
    edge = along > 0 && along < whole ? k : -1;
    vertex = edge >= 0 ? -1 : along <= 0 ? k : k == 2 ? 0 : k + 1;
  }
  Vec3 out = n;
  bool is_local = true;
  if (edge >= 0) {
    const Vec3 a = corner[edge], e = corner[edge == 2 ? 0 : edge + 1] - a;
    out = n + s.beside[edge];
    // The neighbour, whose edge runs the other way, must fall off from there.
    is_local = dot(way, cross(e, s.beside[edge])) <= 0;
  } else if (vertex >= 0) {
    out = s.at[vertex];
    is_local = false;
  }
  const float side = dot(way, out) < 0 ? -1.0f : 1.0f;
  return {way, length(way), side, is_local, normalized_or(side * way, normalized_or(out, n))};
}

/// A place where a point touches.
struct GroundTouch {
  Vec3 normal;     ///< unit, outwards
  float distance;  ///< m, negative inside
};

/// Which places count.
struct TouchRange {
  float reach;  ///< m: outside
  float depth;  ///< m: inside
  float slack;  ///< m: less is rounding
};

/// Calls visit(GroundTouch) for each place that is nearer to p than all places around it. For a point inside
/// it is the nearest place alone. Only places whose normals are allowed(normal) count.
template <class Allowed, class Visit>
MENISCUS_HD void each_touch(const Ground& ground, Vec3 p, const TouchRange& range, const Allowed& allowed,
                            const Visit& visit) {
  const auto at = [&](uint32_t i) {
    return nearest_on_triangle(ground.triangles[i], ground.seams[i], p, range.slack);
  };
  const float most = pbd::max(range.reach, range.depth);
  float least = most, of_all = most, side = 0;
  uint32_t nearest = no_edge, first = no_edge;
  ground.each_near(p, {0, 0, 0}, most, [&](uint32_t i) {
    const NearestOnTriangle here = at(i);
    if (here.size < of_all) {
      of_all = here.size;
      first = i;
    }
    if (here.size >= least || !here.is_local || !allowed(here.normal)) return;
    least = here.size;
    side = here.side;
    nearest = i;
  });
  // A corner counts only if no other place is nearer.
  if (first != no_edge && !at(first).is_local && allowed(at(first).normal)) {
    nearest = first;
    least = of_all;
    side = at(first).side;
  }
  if (nearest == no_edge || (side > 0 && least > range.reach)) return;
  visit(GroundTouch{at(nearest).normal, side * least});
  if (side < 0) return;
  ground.each_near(p, {0, 0, 0}, range.reach, [&](uint32_t i) {
    const NearestOnTriangle here = at(i);
    const float distance = here.side * here.size;
    if (i == nearest || !here.is_local || distance < -range.slack || distance > range.reach) return;
    if (allowed(here.normal)) visit(GroundTouch{here.normal, distance});
  });
}

}  // namespace meniscus::collision
