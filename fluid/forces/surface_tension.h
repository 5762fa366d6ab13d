// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Forces between pairs that pull a fluid's surface together, after Akinci, Akinci & Teschner (2013):
//
//   cohesion   F = −a_i a_j A(r) (x_i − x_j)/r                  attraction, with a repulsive core
//   curvature  F = ½ (b_i + b_j) B V W (n_j − n_i), n_i = h Σ b_j V ∇W
//
// Cohesion alone holds threads and sheets together, but is stiff: a cube of fluid does not quite become a
// ball. Curvature alone has no hold on single particles. Half of each is a tension: a drop swings with
// Rayleigh's period. In the original the curvature term has no weight, and jumps where a neighbour comes into
// reach.
//
// The factors a and b are roots of tensions, so that products follow Berthelot's rule: where two fluids meet
// the tension is (√σ₁ − √σ₂)², none between equal ones.
#pragma once

#include "fluid/kernel/kernel.h"
#include "fluid/kernel/material.h"

namespace meniscus::fluid {

/// The pair forces of a flat surface of the rest lattice, scaled to the tension that is asked for.
struct TensionKernel {
  float h;
  float inverse_peak;     ///< 4/h²
  float cohesion_scale;   ///< of A, m: N from N/m
  float curvature_scale;  ///< B, m

  /// A at distance r, no further than h.
  template <class R>
  MENISCUS_HD R attraction(const R& r) const {
    const R u = max(R(h) - r, R(0.0f));
    const R t = R(inverse_peak) * (u * (R(h) - u));
    const R t3 = t * t * t;
    return R(cohesion_scale) * select_less(r, R(0.5f * h), R(2.0f) * t3 - R(1.0f), t3);
  }
};

TensionKernel calibrate_tension(const Kernel& kernel, double spacing);

/// What one fluid brings into its pairs, √(N/m).
struct Affinity {
  float cohesion;   ///< a
  float curvature;  ///< b
};

Affinity affinity_of(const Material& material);

}  // namespace meniscus::fluid
