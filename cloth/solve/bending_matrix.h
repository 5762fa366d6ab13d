// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The constant matrix of isometric bending.
#pragma once

#include <span>
#include <vector>

#include "cloth/build/constraints.h"
#include "cloth/build/piece.h"

namespace meniscus::cloth {

/// Q = Σ k kᵀ D/(A₁ + A₂) over isometric hinges, J/m², whose energy is ½ xᵀQx in each component. Each row
/// adds up to 0, so the diagonal is left out: (Qx)_i = Σ_j Q_ij (x_j − x_i).
///
/// Rows lie side by side in slices. Entry k of row i has the place slice_start[i / slice] + slice · k + i %
/// slice. Rows are filled up to the longest of their slice with entries of 0 at their own column.
struct BendingMatrix {
  static constexpr uint32_t slice = 32;

  std::vector<uint32_t> slice_start;
  std::vector<uint32_t> column;
  std::vector<float> value;  ///< J/m²
};

/// `masses`: kg, of all vertices. The matrix is empty if there are no hinges.
BendingMatrix bending_matrix(std::span<const IsometricConstraint> hinges, std::span<const float> masses);

/// How fast a piece bends.
struct BendingRate {
  float fastest = 0;  ///< 1/s²: no eigenvalue of M⁻¹Q is greater (Collatz & Wielandt's bound)
  float typical = 0;  ///< 1/s²: Σ k²/m · D/(A₁ + A₂) of the median hinge
  float damping = 0;  ///< τ, s
};

/// By piece.
std::vector<BendingRate> bending_rates(const BendingMatrix& matrix,
                                       std::span<const IsometricConstraint> hinges,
                                       std::span<const float> masses, std::span<const Piece> pieces);

}  // namespace meniscus::cloth
