// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Builds the constraints of stretch and shear.
#include "cloth/build/stretch.h"

#include <Eigen/Dense>
#include <algorithm>

namespace meniscus::cloth {

namespace {

using Eigen::Matrix2d;
using Eigen::Vector3d;

float compliance_of(double stiffness) {
  return static_cast<float>(std::min(1 / stiffness, most_compliance));
}

// fraction/k. A fraction within rounding of 0 counts as 0, whatever k is.
double yield(double fraction, double stiffness) {
  return fraction < 1e-9 ? 0 : fraction / stiffness;
}

// The surroundings of an edge: its triangles.
struct Surroundings {
  double area = 0;
  double cos2 = 0;  // mean over the triangles, of the angle to the warp
};

Surroundings around(std::span<const EdgeUse> edge, const Vector3d& direction,
                    const std::vector<TriangleAtRest>& triangles) {
  Surroundings s;
  for (const EdgeUse& use : edge) {
    const TriangleAtRest& t = triangles[use.triangle];
    const double cosine = direction.dot(t.warp);
    s.area += t.area;
    s.cos2 += cosine * cosine / static_cast<double>(edge.size());
  }
  return s;
}

}  // namespace

double yield_along(double cos2, const FabricParameters& fabric) {
  const double sin2 = std::max(0.0, 1 - cos2);
  return yield(cos2 * cos2, fabric.warp_stiffness) + yield(sin2 * sin2, fabric.weft_stiffness) +
         yield(cos2 * sin2, fabric.shear_stiffness);
}

std::vector<EdgeConstraint> stretch_of_edges(const ClothMesh& mesh, std::span<const EdgeUse> uses,
                                             const std::vector<TriangleAtRest>& triangles,
                                             const FabricParameters& fabric) {
  std::vector<EdgeConstraint> edges;
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    const uint32_t a = edge[0].low, b = edge[0].high;
    const Vector3d ab = to_double(mesh.vertices[b]) - to_double(mesh.vertices[a]);
    const Surroundings s = around(edge, ab.normalized(), triangles);
    const double compliance = ab.squaredNorm() / s.area * yield_along(s.cos2, fabric);
    if (compliance > most_compliance) return;
    edges.push_back({a, b, static_cast<float>(ab.norm()), static_cast<float>(compliance)});
  });
  return edges;
}

std::vector<StrainConstraint> strain_of_triangles(const ClothMesh& mesh,
                                                  const std::vector<TriangleAtRest>& triangles,
                                                  const FabricParameters& fabric) {
  std::vector<StrainConstraint> strains;
  strains.reserve(triangles.size());
  for (size_t i = 0; i < triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    const TriangleAtRest& rest = triangles[i];
    const Vector3d a = to_double(mesh.vertices[t[0]]), weft = rest.normal.cross(rest.warp);
    const Vector3d ab = to_double(mesh.vertices[t[1]]) - a, ac = to_double(mesh.vertices[t[2]]) - a;
    Matrix2d sides;
    sides << rest.warp.dot(ab), rest.warp.dot(ac), weft.dot(ab), weft.dot(ac);
    const Eigen::Matrix2f inverse = sides.inverse().cast<float>();
    strains.push_back({t[0],
                       t[1],
                       t[2],
                       {inverse(0, 0), inverse(0, 1), inverse(1, 0), inverse(1, 1)},
                       compliance_of(fabric.warp_stiffness * rest.area),
                       compliance_of(fabric.weft_stiffness * rest.area),
                       compliance_of(fabric.shear_stiffness * rest.area)});
  }
  std::stable_sort(strains.begin(), strains.end(), [](const StrainConstraint& s, const StrainConstraint& t) {
    return std::min({s.a, s.b, s.c}) < std::min({t.a, t.b, t.c});
  });
  return strains;
}

}  // namespace meniscus::cloth
