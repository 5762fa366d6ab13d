// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Separation of neighbours with cloth between them. Each side gets mirror ghosts of the cloth instead.
#pragma once

#include "collision/fluid_cloth/find.h"
#include "pbd/neighbours.h"

namespace meniscus::collision::fluid_cloth_kernels {

/// Removes neighbours on the other side of a triangle from the near particles' lists. It uses the positions
/// at the substep's start, when no particle had passed through cloth. Both ends of a pair test the same
/// segment, computed in the same way, and each removes the other. A warp works on a particle. Its threads
/// share 32 neighbours, and all search for triangles together.
struct PartNeighbours {
  Surface surface;
  NearList near;
  pbd::NeighbourView neighbours;
  float h;

  MENISCUS_HD void operator()(uint32_t k) const {
    if (k >= near.count()) return;
    const uint32_t i = near.particle[k], count = neighbours.size(i);
    for (uint32_t first = 0; first < count; first += SearchTeam::most) part(i, first, count);
  }

 private:
  static constexpr uint32_t self_count = SearchTeam::most / SearchTeam::count();

  struct Neighbour {
    uint32_t j;  // or the sentinel
    Aabb box;    // box of the segment to it
  };

  /// Tests the neighbours from `first` on. A particle that passes through the piece stays a neighbour of both
  /// sides.
  MENISCUS_HD void part(uint32_t i, uint32_t first, uint32_t count) const {
    Neighbour self[self_count];
    for (uint32_t k = 0; k < self_count; ++k) self[k] = neighbour(i, place(first, k), count);
    Aabb all = self[0].box;
    for (uint32_t k = 1; k < self_count; ++k) all = pbd::joined(all, self[k].box);
    all = {SearchTeam::least(all.lower), -SearchTeam::least(-all.upper)};
    pbd::OverlapWalk<pbd::TestTogether> walk(surface.tree, surface.world_of(i), all, 1);
    for (uint32_t above, boxes; walk.next_group(above, boxes);) {
      for (uint32_t k = 0; k < self_count; ++k) {
        if (self[k].j == neighbours.sentinel || !are_parted_by(above, boxes, i, self[k])) continue;
        neighbours.drop(i, place(first, k));
        self[k].j = neighbours.sentinel;
      }
    }
  }

  MENISCUS_HD static uint32_t place(uint32_t first, uint32_t k) {
    return first + SearchTeam::rank() + k * SearchTeam::count();
  }

  MENISCUS_HD Neighbour neighbour(uint32_t i, uint32_t n, uint32_t count) const {
    const uint32_t sentinel = neighbours.sentinel, j = n < count ? neighbours.at(i, n) : sentinel;
    const Vec3 p = load(surface.previous, i).xyz(), q = j == sentinel ? p : load(surface.previous, j).xyz();
    constexpr float slack = 1e-4f;  // more than the tolerance in passes()
    return {j, motion_box(p, q, slack * h)};
  }

  /// Whether a triangle of some of eight groups separates the two.
  MENISCUS_HD bool are_parted_by(uint32_t above, uint32_t boxes, uint32_t i, const Neighbour& self) const {
    boxes &= pbd::overlap_mask(surface.tree.group(1, above), self.box);
    for (; boxes; boxes &= boxes - 1)
      if (are_parted_by(8 * above + pbd::lowest_bit(boxes), self.box, i, self.j)) return true;
    return false;
  }

  /// Whether one of eight triangles separates the two.
  MENISCUS_HD bool are_parted_by(uint32_t group, const Aabb& box, uint32_t i, uint32_t j) const {
    const Vec3 p = load(surface.previous, i < j ? i : j).xyz(),
               q = load(surface.previous, i < j ? j : i).xyz();
    for (uint32_t left = pbd::overlap_mask(surface.tree.group(0, group), box); left; left &= left - 1) {
      const pbd::SurfaceTriangle t = load(surface.tree.triangles, 8 * group + pbd::lowest_bit(left));
      if (surface.meets(i, t.piece) && surface.meets(j, t.piece) && passes(p, q, t)) return true;
    }
    return false;
  }

  /// Whether the segment meets the triangle, within a support radius of both its ends.
  MENISCUS_HD bool passes(Vec3 p, Vec3 q, const pbd::SurfaceTriangle& t) const {
    const Vec3 a = surface.start(t.a), b = surface.start(t.b), c = surface.start(t.c);
    const Vec3 n = cross(b - a, c - a);
    const float above = dot(n, p - a), below = dot(n, q - a);
    if ((above >= 0) == (below >= 0)) return false;
    const Vec3 x = p + above / (above - below) * (q - p);
    if (pbd::max(max_component(abs(x - p)), max_component(abs(x - q))) > h) return false;
    const Vec3 displacement = q - p, ap = a - p, bp = b - p, cp = c - p;
    const float u = dot(displacement, cross(bp, cp)), v = dot(displacement, cross(cp, ap)),
                w = dot(displacement, cross(ap, bp));
    // A segment through an edge goes through at least one of the edge's triangles.
    const float slack = 1e-5f * (fabsf(u) + fabsf(v) + fabsf(w));
    return (u >= -slack && v >= -slack && w >= -slack) || (u <= slack && v <= slack && w <= slack);
  }
};

}  // namespace meniscus::collision::fluid_cloth_kernels
