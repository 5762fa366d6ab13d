// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Computes convex hulls, with Bullet.
#include "collision/mesh/hull.h"

#include <LinearMath/btConvexHullComputer.h>
#include <meniscus/error.h>

#include <cmath>
#include <utility>

#include "collision/mesh/bullet_memory.h"
#include "collision/mesh/tuning.h"
#include "pbd/math/vec.h"

namespace meniscus::collision {

namespace {

/// Appends a face as a fan of triangles.
void append_face(TriangleMesh& mesh, const btConvexHullComputer& hull, int face) {
  const btConvexHullComputer::Edge* first = &hull.edges[hull.faces[face]];
  const auto corner = static_cast<uint32_t>(first->getSourceVertex());
  for (const auto* edge = first->getNextEdgeOfFace(); edge->getNextEdgeOfFace() != first;
       edge = edge->getNextEdgeOfFace()) {
    mesh.triangles.push_back({corner, static_cast<uint32_t>(edge->getSourceVertex()),
                              static_cast<uint32_t>(edge->getTargetVertex())});
  }
}

}  // namespace

std::optional<TriangleMesh> find_hull(std::span<const Vec3> points) {
  TriangleMesh mesh;
  if (points.size() >= 4) {
    BulletReserve reserve;
    const InBullet bullet(reserve, points.size());
    btConvexHullComputer hull;
    hull.compute(&points[0].x, sizeof(Vec3), static_cast<int>(points.size()), 0, 0);
    // The original points: Bullet rounds its results to a ten-thousandth of the size.
    for (int v = 0; v < hull.vertices.size(); ++v)
      mesh.vertices.push_back(points[static_cast<size_t>(hull.original_vertex_index[v])]);
    for (int face = 0; face < hull.faces.size(); ++face) append_face(mesh, hull, face);
  }
  const double volume = mesh.triangles.size() >= 4 ? signed_volume(mesh) : 0;
  const Vec3 size = mesh.vertices.empty() ? Vec3{0, 0, 0} : bounds(mesh).upper - bounds(mesh).lower;
  if (!(std::fabs(volume) > mesh_tuning::least_volume * std::pow(double{length(size)}, 3)))
    return std::nullopt;
  if (volume < 0) {
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  }
  return mesh;
}

TriangleMesh hull_mesh(std::span<const Vec3> points) {
  std::optional<TriangleMesh> mesh = find_hull(points);
  if (!mesh) {
    throw Error(ErrorCode::invalid_argument,
                "HullGeometry::points has " + std::to_string(points.size()) +
                    " points that span no volume; it must have 4 or more that do not lie in a plane");
  }
  return std::move(*mesh);
}

}  // namespace meniscus::collision
