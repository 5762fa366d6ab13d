// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Builds the hinge constraints of bending.
#include "cloth/build/bending.h"

#include <Eigen/Geometry>
#include <cmath>

#include "cloth/build/bending_balance.h"
#include "cloth/build/tuning.h"

namespace meniscus::cloth {

namespace {

using Eigen::Vector3d;

struct Corners {
  Vector3d a, b, c, d;
};

// θ of HingeConstraint: positive if c and d have moved towards the side that the normal of (a, b, c) points
// to.
double angle_at_rest(const Corners& x) {
  const Vector3d edge = x.b - x.a;
  const Vector3d first = edge.cross(x.c - x.a), second = (x.d - x.a).cross(edge);
  return std::atan2(second.cross(first).dot(edge) / edge.norm(), first.dot(second));
}

double cotangent(const Vector3d& u, const Vector3d& v) {
  return u.dot(v) / u.cross(v).norm();
}

// Each triangle adds l times the unit vector from its third corner to the edge, in its own plane. So their
// sum has the length l · 2 sin(θ/2).
std::array<double, 4> weights_of(const Corners& x) {
  const Vector3d edge = x.b - x.a;
  const double a1 = cotangent(edge, x.c - x.a), b1 = cotangent(-edge, x.c - x.b);
  const double a2 = cotangent(edge, x.d - x.a), b2 = cotangent(-edge, x.d - x.b);
  return {b1 + b2, a1 + a2, -a1 - b1, -a2 - b2};
}

/// A third of the triangles at each vertex; 0 at borders and where the cloth is not flat at rest.
std::vector<double> flat_areas(const ClothMesh& mesh, std::span<const EdgeUse> uses,
                               const std::vector<TriangleAtRest>& triangles, const std::vector<bool>& bent) {
  std::vector<double> areas(mesh.vertices.size(), 0);
  for (size_t t = 0; t < triangles.size(); ++t) {
    for (uint32_t v : mesh.triangles[t]) areas[v] += triangles[t].area / 3;
  }
  for (uint32_t v = 0; v < bent.size(); ++v) {
    if (bent[v]) areas[v] = 0;
  }
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() != 2) areas[edge[0].low] = areas[edge[0].high] = 0;
  });
  return areas;
}

}  // namespace

Hinges bending_of_edges(const ClothMesh& mesh, std::span<const EdgeUse> uses,
                        const std::vector<TriangleAtRest>& triangles, const FabricParameters& fabric) {
  if (fabric.bending_stiffness == 0) return {};
  std::vector<FlatHinge> all;
  std::vector<double> rest_angle;
  std::vector<bool> bent(mesh.vertices.size(), false);
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() != 2) return;
    const uint32_t a = edge[0].forward ? edge[0].low : edge[0].high;
    const uint32_t b = edge[0].forward ? edge[0].high : edge[0].low;
    const uint32_t c = edge[0].opposite, d = edge[1].opposite;
    const Corners x{to_double(mesh.vertices[a]), to_double(mesh.vertices[b]), to_double(mesh.vertices[c]),
                    to_double(mesh.vertices[d])};
    const double area = triangles[edge[0].triangle].area + triangles[edge[1].triangle].area;
    all.push_back({a, b, c, d, weights_of(x), 1 / area});
    rest_angle.push_back(angle_at_rest(x));
    if (std::abs(rest_angle.back()) >= build_tuning::flat_angle) bent[a] = bent[b] = true;
  });
  const std::vector<double> factor = balanced(all, mesh.vertices, flat_areas(mesh, uses, triangles, bent));
  Hinges hinges;
  for (size_t k = 0; k < all.size(); ++k) {
    const FlatHinge& h = all[k];
    const double compliance = 1 / (fabric.bending_stiffness * h.stiffness * factor[k]);
    if (!fabric.dihedral && std::abs(rest_angle[k]) < build_tuning::flat_angle) {
      hinges.isometric.push_back({h.a,
                                  h.b,
                                  h.c,
                                  h.d,
                                  {static_cast<float>(h.weight[1]), static_cast<float>(h.weight[2]),
                                   static_cast<float>(h.weight[3])},
                                  static_cast<float>(compliance)});
    } else {
      const double l2 = (to_double(mesh.vertices[h.b]) - to_double(mesh.vertices[h.a])).squaredNorm();
      hinges.dihedral.push_back(
          {h.a, h.b, h.c, h.d, static_cast<float>(rest_angle[k]), static_cast<float>(compliance / l2)});
    }
  }
  return hinges;
}

}  // namespace meniscus::cloth
