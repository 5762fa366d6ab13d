// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Balances the stiffness of hinges, so that flat cloth is equally stiff in all directions.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "cloth/build/cloth_mesh.h"

namespace meniscus::cloth {

/// A hinge that is flat at rest: its edge (a, b), and the corners c and d of its triangles.
struct FlatHinge {
  uint32_t a, b, c, d;
  std::array<double, 4> weight;  ///< k of each: those of IsometricConstraint
  double stiffness;              ///< over D, 1/m²: 1/(A₁ + A₂)

  std::array<uint32_t, 4> corners() const { return {a, b, c, d}; }
};

/// By hinge, the factor of its stiffness with which cloth is equally stiff in all directions. Around a vertex
/// inside the cloth, bent by κ across the direction n, the hinges at its edges have half of their energy for
/// the vertex's area A. The factors f are those nearest 1 with which this is right for all n:
///
///   ½ Σ f K (Σ_i k_i ½ κ (n·x_i)²)² = κ² A
///
/// Without them a grid is 1.75 times too stiff at 45°. A hinge takes the mean of what the vertices at its
/// ends find. The energy of a bend is the cloth's stiffness only where the bend is in equilibrium, as on
/// regular meshes. On others vertices give way, and hinges keep their factor of 1. `areas`: m², by vertex, a
/// third of each of its triangles; 0: not to be balanced.
std::vector<double> balanced(std::span<const FlatHinge> hinges, std::span<const Vec3> rest,
                             std::span<const double> areas);

}  // namespace meniscus::cloth
