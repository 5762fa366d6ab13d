// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Shapes of groups of eight neighbouring triangles, which cull most of the triangles around a particle.
#pragma once

#include "collision/fluid_cloth/cloth_surface.h"
#include "collision/fluid_cloth/marks.h"

namespace meniscus::collision::fluid_cloth_kernels {

/// The bound of a group. All corners lie within `radius` of the centre at the substep's end. No unit normal
/// differs from the axis by more than `bend`.
struct alignas(16) GroupShape {
  Vec3 centre;
  float radius;  // m
  Vec3 axis;     // unit
  float bend;

  /// Whether p may lie straight above or below one of the triangles, in the direction of its normal. Then its
  /// distance from the centre across the axis is at most that of the corners, apart from the differences of
  /// the normals.
  MENISCUS_HD bool may_be_over(Vec3 p) const {
    const Vec3 d = p - centre, across = cross(d, axis);
    const float far = 1.001f * radius + bend * length(d);
    return dot(across, across) <= far * far;
  }
};

/// Computes the shape of each group, with a team each. A group with a border may be below anything: it is
/// always tested.
struct FitShapes {
  Surface surface;
  View<GroupShape> shapes;

  MENISCUS_HD void operator()(uint32_t g) const {
    Vec3 centre{0, 0, 0}, axis{0, 0, 0};
    float corners = 0;
    for_each(g, [&](Vec3 a, Vec3 b, Vec3 c, uint32_t) {
      centre += a + b + c;
      corners += 3;
      axis += cross(b - a, c - a);
    });
    centre = (1 / pbd::max(1, GroupTeam::sum(corners))) * GroupTeam::sum(centre);
    axis = normalized_or(GroupTeam::sum(axis), {0, 0, 0});
    float far2 = 0, bend2 = 0;
    for_each(g, [&](Vec3 a, Vec3 b, Vec3 c, uint32_t marks) {
      for (Vec3 x : {a, b, c}) far2 = pbd::max(far2, dot(x - centre, x - centre));
      const Vec3 off = normalized_or(cross(b - a, c - a), {0, 0, 0}) - axis;
      bend2 = pbd::max(bend2, marks & border_marks ? 1e10f : dot(off, off));
    });
    far2 = -GroupTeam::least(-far2), bend2 = -GroupTeam::least(-bend2);
    if (GroupTeam::leads()) shapes[g] = {centre, sqrtf(far2), axis, sqrtf(bend2)};
  }

 private:
  template <class Visit>
  MENISCUS_HD void for_each(uint32_t g, const Visit& visit) const {
    for (uint32_t k = GroupTeam::rank(); k < pbd::BoxGroup::size; k += GroupTeam::count()) {
      const uint32_t place = pbd::BoxGroup::size * g + k;
      const pbd::SurfaceTriangle t = load(surface.tree.triangles, place);
      if (t.a != no_index) visit(surface.end(t.a), surface.end(t.b), surface.end(t.c), surface.marks[place]);
    }
  }
};

}  // namespace meniscus::collision::fluid_cloth_kernels
