// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Pairwise forces that contract a fluid's surface, after Akinci, Akinci & Teschner (2013):
//
//   cohesion   F = −a_i a_j A(r) (x_i − x_j)/r                  attraction, with a repulsive core
//   curvature  F = ½ (b_i + b_j) B V W (n_j − n_i), n_i = h Σ b_j V ∇W
//
// Cohesion alone preserves threads and sheets, but is stiff: a cube of fluid does not quite become a ball.
// Curvature alone has no effect on single particles. With half of each, a drop oscillates with Rayleigh's
// period. In the original, the curvature term has no weight, and is discontinuous when a neighbour comes into
// reach.
//
// The factors a and b are square roots of tensions, so that products follow Berthelot's rule: the tension
// between two fluids is (√σ₁ − √σ₂)², and 0 between equal ones.
#pragma once

#include "fluid/kernel/kernel.h"
#include "fluid/kernel/material.h"

namespace meniscus::fluid {

/// The pair forces, scaled so that a flat surface of the rest lattice has the given tension.
struct TensionKernel {
  float h;
  float inverse_peak;     ///< 4/h²
  float cohesion_scale;   ///< of A, m: N from N/m
  float curvature_scale;  ///< B, m

  /// A at distance r ≤ h.
  template <class R>
  MENISCUS_HD R attraction(const R& r) const {
    const R u = max(R(h) - r, R(0.0f));
    const R t = R(inverse_peak) * (u * (R(h) - u));
    const R t3 = t * t * t;
    return R(cohesion_scale) * select_less(r, R(0.5f * h), R(2.0f) * t3 - R(1.0f), t3);
  }
};

TensionKernel calibrate_tension(const Kernel& kernel, double spacing);

/// The factors of one fluid in its pairs, √(N/m).
struct Affinity {
  float cohesion;   ///< a
  float curvature;  ///< b
};

Affinity affinity_of(const Material& material);

}  // namespace meniscus::fluid
