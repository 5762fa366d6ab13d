// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A relaxed packing without order, on which consistent kernels are calibrated, and sums over packings.
#pragma once

#include <array>
#include <vector>

#include "fluid/kernel/kernel.h"

namespace meniscus::fluid {

/// W and |∇W| of a kernel in double, at distance r and support radius h.
struct ExactKernel {
  SmoothingKernel shape;
  double h;

  double weight(double r) const;
  double slope(double r) const;
};

/// Points in a periodic cube. Lengths are in spacings: a point has the volume 1.
struct Packing {
  double side;
  std::vector<std::array<double, 3>> points;
};

/// Means over the points of a packing.
struct PackingSums {
  double weight;     ///< Σ W, the point itself included
  double gradient;   ///< Σ |∇W| r/3
  double gradient2;  ///< Σ |∇W|²
};

Packing cubic_lattice(double support_radius);
/// Points that start at random and relax under the same multiplier for all, so Σ e_i becomes 0 at each. It is
/// the same for the same kernel.
Packing relaxed_packing(const ExactKernel& kernel);
PackingSums sum_over(const Packing& packing, const ExactKernel& kernel);
/// The greatest eigenvalue of D⁻¹A for the same mass everywhere (density_set.h).
double spectral_radius(const Packing& packing, const ExactKernel& kernel);

}  // namespace meniscus::fluid
