// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Checks a fabric, and builds the constraints and vertex masses of a mesh.
#include "cloth/build/build_constraints.h"

#include <array>
#include <utility>

#include "cloth/build/bending.h"
#include "cloth/build/colouring.h"
#include "cloth/build/stretch.h"

namespace meniscus::cloth {

namespace {

std::vector<float> lumped_masses(const ClothMesh& mesh, const std::vector<TriangleAtRest>& triangles,
                                 float density) {
  std::vector<double> masses(mesh.vertices.size(), 0);
  for (size_t t = 0; t < triangles.size(); ++t) {
    for (uint32_t v : mesh.triangles[t]) masses[v] += density * triangles[t].area / 3;
  }
  return {masses.begin(), masses.end()};
}

std::array<uint32_t, 2> corners(const EdgeConstraint& e) {
  return {e.a, e.b};
}
std::array<uint32_t, 3> corners(const StrainConstraint& s) {
  return {s.a, s.b, s.c};
}
std::array<uint32_t, 4> corners(const HingeConstraint& h) {
  return {h.a, h.b, h.c, h.d};
}

template <class Constraint>
Coloured<Constraint> coloured(const std::vector<Constraint>& constraints, size_t vertices) {
  using Vertices = decltype(corners(constraints[0]));
  std::vector<Vertices> all(constraints.size());
  for (size_t i = 0; i < all.size(); ++i) all[i] = corners(constraints[i]);
  const std::span<const Vertices> view = all;
  return sorted_by_colour<Constraint>(constraints, colour_constraints(view, static_cast<uint32_t>(vertices)));
}

}  // namespace

ClothConstraints build_constraints(const ClothMesh& mesh, const FabricParameters& fabric) {
  const size_t vertices = mesh.vertices.size();
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  const std::vector<TriangleAtRest> triangles = triangles_at_rest(mesh);
  ClothConstraints result;
  result.masses = lumped_masses(mesh, triangles, fabric.density);
  if (fabric.strain_triangles) {
    result.strains = coloured(strain_of_triangles(mesh, triangles, fabric), vertices);
  } else {
    result.edges = coloured(stretch_of_edges(mesh, uses, triangles, fabric), vertices);
  }
  Hinges hinges = bending_of_edges(mesh, uses, triangles, fabric);
  result.hinges = coloured(hinges.dihedral, vertices);
  result.isometric = std::move(hinges.isometric);
  return result;
}

}  // namespace meniscus::cloth
