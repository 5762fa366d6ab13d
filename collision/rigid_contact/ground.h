// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Meshes and height fields as contacts read them: a tree of triangles, with the normals beside and around
// each.
#pragma once

#include "collision/mesh/triangle_bvh.h"
#include "collision/mesh/triangle_bvh_query.h"

namespace meniscus::collision {

/// What lies beside a triangle. The sum of the normals of both sides of an edge, and the angle-weighted one
/// at a corner, tell inside from outside (Bærentzen & Aanæs 2005).
struct TriangleSeams {
  Vec3 beside[3];    ///< unit normals across the edges ab, bc, ca; 0 where the surface ends
  Vec3 at[3];        ///< sums of normals at a, b, c
  uint32_t edge[3];  ///< numbers of the edges that are sharp and convex; none: others, and those it shares
};

inline constexpr uint32_t no_edge = ~0u;

/// On the host. Its frame has the middle of its box as the origin.
struct ContactGround {
  std::vector<BvhNode> nodes;
  std::vector<Triangle> triangles;
  std::vector<TriangleSeams> seams;  ///< by triangle of the tree
  Vec3 centre{0, 0, 0};              ///< m, of its frame, where the mesh has its own
  Vec3 half{0, 0, 0};                ///< m, of its box
};

/// Throws Error(mesh) when there are no triangles.
ContactGround make_contact_ground(const TriangleMesh& mesh);

/// Where a ground lies in the arrays of all.
struct GroundRange {
  uint32_t first_node, nodes, first_triangle, triangles;
};

/// As kernels read it, in its own frame.
struct Ground {
  pbd::View<const BvhNode> nodes;
  pbd::View<const Triangle> triangles;
  pbd::View<const TriangleSeams> seams;

  /// Calls visit(slot) for the triangles of leaves within `reach` of a box.
  template <class Visit>
  MENISCUS_HD void each_near(Vec3 middle, Vec3 half, float reach, const Visit& visit) const {
    const auto is_apart = [&](float lower, float upper, float at, float size) {
      return at - size - reach > upper || at + size + reach < lower;
    };
    for (uint32_t at = 0; at < nodes.count;) {
      const BvhNode& n = nodes[at];
      if (is_apart(n.lower.x, n.upper.x, middle.x, half.x) ||
          is_apart(n.lower.y, n.upper.y, middle.y, half.y) ||
          is_apart(n.lower.z, n.upper.z, middle.z, half.z)) {
        at = n.end;
        continue;
      }
      for (uint32_t i = n.first; i < n.first + n.count; ++i) visit(i);
      ++at;
    }
  }
};

/// All grounds of a world.
struct GroundTable {
  pbd::View<const GroundRange> grounds;
  pbd::View<const BvhNode> nodes;
  pbd::View<const Triangle> triangles;
  pbd::View<const TriangleSeams> seams;

  MENISCUS_HD Ground of(uint32_t number) const {
    const GroundRange r = grounds[number];
    return {{nodes.data + r.first_node, r.nodes},
            {triangles.data + r.first_triangle, r.triangles},
            {seams.data + r.first_triangle, r.triangles}};
  }
};

}  // namespace meniscus::collision
