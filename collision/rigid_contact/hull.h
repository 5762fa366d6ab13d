// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Convex hulls as contacts read them: vertices, faces and edges. A box is a cube that is scaled.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "collision/rigid_contact/manifold.h"
#include "pbd/device/base/view.h"
#include "pbd/math/vec.h"

namespace meniscus::collision {

/// A polygon. Its corners are in order, counter-clockwise as seen from outside. The first one is outermost.
struct HullFace {
  Vec3 normal;            ///< unit
  uint32_t first, count;  ///< in the list of corners
};

/// From one vertex to another, with the faces beside it.
struct HullEdge {
  uint32_t from, to, left, right;
};

inline constexpr uint32_t most_hull_vertices = 64;

/// A hull on the host. Its frame has the middle of its box as the origin.
struct ContactHull {
  std::vector<Vec3> vertices;  ///< m
  std::vector<HullFace> faces;
  std::vector<uint32_t> corners;  ///< of faces: numbers of vertices
  std::vector<HullEdge> edges;
  Vec3 centre{0, 0, 0};  ///< m, of its frame, where the points have theirs
  Vec3 half{0, 0, 0};    ///< m, of its box
  float radius = 0;      ///< m, of the ball around its origin
  float error = 0;       ///< m: how far points lie outside, as they are too many
};

/// The hull of points. Faces whose planes agree to hull_flatness of the radius are one. A hull of more than
/// most_hull_vertices keeps the vertices that stand out most. Throws Error(invalid_argument) where the points
/// span no volume.
ContactHull make_contact_hull(std::span<const Vec3> points);

/// Where a hull lies in the arrays of all hulls.
struct HullRange {
  uint32_t first_vertex, vertices, first_face, faces, first_corner, corners, first_edge, edges;
};

/// A hull as kernels read it, in its own frame.
struct Polytope {
  pbd::View<const Vec3> vertices;
  pbd::View<const HullFace> faces;
  pbd::View<const uint32_t> corners;
  pbd::View<const HullEdge> edges;
  Vec3 scale;  ///< half extents of a box, 1 for hulls

  MENISCUS_HD Vec3 vertex(uint32_t i) const {
    const Vec3 v = vertices[i];
    return {scale.x * v.x, scale.y * v.y, scale.z * v.z};
  }
  MENISCUS_HD Vec3 normal(uint32_t face) const { return faces[face].normal; }
  MENISCUS_HD uint32_t corner_count(uint32_t face) const { return faces[face].count; }
  MENISCUS_HD uint32_t corner_number(uint32_t face, uint32_t k) const {
    return corners[faces[face].first + k];
  }
  /// Corner k of a face, or the first one after the last.
  MENISCUS_HD Vec3 corner(uint32_t face, uint32_t k) const {
    return vertex(corner_number(face, k < faces[face].count ? k : 0));
  }
  /// m: of a point from the plane of a face.
  MENISCUS_HD float from_face(uint32_t face, Vec3 p) const { return dot(normal(face), p - corner(face, 0)); }
  /// m: the furthest of its vertices along a direction.
  MENISCUS_HD float furthest(Vec3 direction) const {
    float most = -1e30f;
    for (uint32_t i = 0; i < vertices.count; ++i) most = pbd::max(most, dot(direction, vertex(i)));
    return most;
  }
  /// The outward normal of a side of a face, within its plane.
  MENISCUS_HD Vec3 side(uint32_t face, uint32_t k) const {
    return cross(corner(face, k + 1) - corner(face, k), normal(face));
  }
};

/// All hulls of a world. The first one is the cube with half extents of 1.
struct HullTable {
  pbd::View<const HullRange> hulls;
  pbd::View<const Vec3> vertices;
  pbd::View<const HullFace> faces;
  pbd::View<const uint32_t> corners;
  pbd::View<const HullEdge> edges;

  /// Of a hull or a box.
  MENISCUS_HD Polytope of(const Convex& part) const {
    const HullRange r = hulls[part.table];
    return {{vertices.data + r.first_vertex, r.vertices},
            {faces.data + r.first_face, r.faces},
            {corners.data + r.first_corner, r.corners},
            {edges.data + r.first_edge, r.edges},
            part.kind == ConvexKind::box ? part.size : Vec3{1, 1, 1}};
  }
};

}  // namespace meniscus::collision
