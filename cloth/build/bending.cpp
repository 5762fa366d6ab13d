// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Builds the hinge constraints of bending.
#include "cloth/build/bending.h"
#include "cloth/build/tuning.h"

#include <Eigen/Geometry>
#include <cmath>

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
void set_weights(const Corners& x, float weight[3]) {
  const Vector3d edge = x.b - x.a;
  const double a1 = cotangent(edge, x.c - x.a), b1 = cotangent(-edge, x.c - x.b);
  const double a2 = cotangent(edge, x.d - x.a), b2 = cotangent(-edge, x.d - x.b);
  weight[0] = static_cast<float>(a1 + a2);
  weight[1] = static_cast<float>(-a1 - b1);
  weight[2] = static_cast<float>(-a2 - b2);
}

}  // namespace

Hinges bending_of_edges(const ClothMesh& mesh, std::span<const EdgeUse> uses,
                        const std::vector<TriangleAtRest>& triangles, const FabricParameters& fabric) {
  Hinges hinges;
  if (fabric.bending_stiffness == 0) return hinges;
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() != 2) return;
    const uint32_t a = edge[0].forward ? edge[0].low : edge[0].high;
    const uint32_t b = edge[0].forward ? edge[0].high : edge[0].low;
    const uint32_t c = edge[0].opposite, d = edge[1].opposite;
    const Corners x{to_double(mesh.vertices[a]), to_double(mesh.vertices[b]), to_double(mesh.vertices[c]),
                    to_double(mesh.vertices[d])};
    const double area = triangles[edge[0].triangle].area + triangles[edge[1].triangle].area;
    const double compliance = area / fabric.bending_stiffness;
    const double rest_angle = angle_at_rest(x);
    if (!fabric.dihedral && std::abs(rest_angle) < build_tuning::flat_angle) {
      IsometricConstraint hinge{a, b, c, d, {}, static_cast<float>(compliance)};
      set_weights(x, hinge.weight);
      hinges.isometric.push_back(hinge);
    } else {
      const double l2 = (x.b - x.a).squaredNorm();
      hinges.dihedral.push_back(
          {a, b, c, d, static_cast<float>(rest_angle), static_cast<float>(compliance / l2)});
    }
  });
  return hinges;
}

}  // namespace meniscus::cloth
