// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Normals, warp directions and areas of triangles at rest.
#include "cloth/build/rest_geometry.h"
#include "cloth/build/tuning.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace meniscus::cloth {

namespace {

using Eigen::Vector3d;

// ∂x/∂u, from the sides at the first corner.
Vector3d along_u(const ClothMesh& mesh, const std::array<uint32_t, 3>& t, const Vector3d& ab,
                 const Vector3d& ac) {
  const auto &a = mesh.material[t[0]], &b = mesh.material[t[1]], &c = mesh.material[t[2]];
  const double bu = double{b[0]} - a[0], bv = double{b[1]} - a[1];
  const double cu = double{c[0]} - a[0], cv = double{c[1]} - a[1];
  const double det = bu * cv - cu * bv;
  const double longest = std::max({bu * bu + bv * bv, cu * cu + cv * cv});
  if (!(std::abs(det) > 1e-6 * longest)) return Vector3d::Zero();
  return (cv * ab - bv * ac) / det;
}

Vector3d default_warp(const Vector3d& normal) {
  const Vector3d axis =
      std::abs(normal.x()) > build_tuning::warp_along_normal ? Vector3d::UnitZ() : Vector3d::UnitX();
  return axis - normal.dot(axis) * normal;
}

}  // namespace

TriangleAtRest triangle_at_rest(const ClothMesh& mesh, uint32_t triangle) {
  const auto& t = mesh.triangles[triangle];
  const Vector3d a = to_double(mesh.vertices[t[0]]);
  const Vector3d ab = to_double(mesh.vertices[t[1]]) - a, ac = to_double(mesh.vertices[t[2]]) - a;
  const Vector3d twice_area = ab.cross(ac);
  const Vector3d normal = twice_area.normalized();
  const Vector3d warp = mesh.material.empty() ? default_warp(normal) : along_u(mesh, t, ab, ac);
  return {normal, warp.normalized(), 0.5 * twice_area.norm()};
}

std::vector<TriangleAtRest> triangles_at_rest(const ClothMesh& mesh) {
  std::vector<TriangleAtRest> result;
  result.reserve(mesh.triangles.size());
  for (uint32_t t = 0; t < mesh.triangles.size(); ++t) result.push_back(triangle_at_rest(mesh, t));
  return result;
}

}  // namespace meniscus::cloth
