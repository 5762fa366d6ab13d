// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What a sheet stands between are no neighbours: each side has the sheet's images instead.
#pragma once

#include "collision/sheet_find.h"
#include "pbd/neighbours.h"

namespace meniscus::collision::sheet_kernels {

/// Takes those out of the near particles' lists that are on the other side of a triangle, at the substep's
/// start, when nothing had passed through anything. Both ends of a pair see the same segment, computed in the
/// same way, and part from one another.
struct PartNeighbours {
  Surface surface;
  NearList near;
  pbd::NeighbourView neighbours;
  uint32_t sentinel;
  float h;

  MENISCUS_HD void operator()(uint32_t k) const {
    if (k >= near.count()) return;
    const uint32_t i = near.particle[k];
    const Vec3 from = surface.previous[i].xyz();
    pbd::for_each_overlap(surface.tree, way_box(from, from, h), 0, 0, [&](uint32_t place) {
      const pbd::SurfaceTriangle t = load(surface.tree.triangles, place);
      if (surface.meets(i, t.part)) part_across(i, from, t);
    });
  }

  /// What passes through the piece stays a neighbour of both sides.
  MENISCUS_HD void part_across(uint32_t i, Vec3 from, const pbd::SurfaceTriangle& t) const {
    const Vec3 a = surface.start(t.a), b = surface.start(t.b), c = surface.start(t.c);
    const Vec3 n = cross(b - a, c - a);
    const float own = dot(n, from - a);
    const uint32_t count = pbd::min(neighbours.count[i], neighbours.row_capacity);
    for (uint32_t k = 0; k < count; ++k) {
      uint32_t& j = neighbours.entry(i, k);
      if (j == sentinel || !surface.meets(j, t.part)) continue;
      const Vec3 to = surface.previous[j].xyz();
      const float other = dot(n, to - a);
      if ((own >= 0) == (other >= 0)) continue;
      const bool first = i < j;
      if (passes(first ? from : to, first ? to : from, first ? own : other, first ? other : own, a, b, c))
        j = sentinel;
    }
  }

  /// Whether the segment meets the triangle, within a support radius of both its ends.
  MENISCUS_HD bool passes(Vec3 p, Vec3 q, float above, float below, Vec3 a, Vec3 b, Vec3 c) const {
    const Vec3 x = p + above / (above - below) * (q - p);
    if (pbd::max(max_component(abs(x - p)), max_component(abs(x - q))) > h) return false;
    const Vec3 way = q - p, ap = a - p, bp = b - p, cp = c - p;
    const float u = dot(way, cross(bp, cp)), v = dot(way, cross(cp, ap)), w = dot(way, cross(ap, bp));
    // What goes through an edge goes through one of its triangles at least.
    const float slack = 1e-5f * (fabsf(u) + fabsf(v) + fabsf(w));
    return (u >= -slack && v >= -slack && w >= -slack) || (u <= slack && v <= slack && w <= slack);
  }
};

}  // namespace meniscus::collision::sheet_kernels
