// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Calibrates the smoothing kernels on the rest lattice.
#include "fluid/kernel/kernel.h"

#include <cmath>
#include <numbers>

namespace meniscus::fluid {

namespace {

struct LatticeSums {
  double weight = 0;     // Σ W over the lattice, the particle itself included
  double gradient = 0;   // Σ |∇W| z²/r
  double gradient2 = 0;  // Σ |∇W|²
};

LatticeSums sum_over_lattice(double s, double h) {
  const double poly6 = 315 / (64 * std::numbers::pi * std::pow(h, 9));
  const double spiky = 45 / (std::numbers::pi * std::pow(h, 6));
  const int reach = static_cast<int>(std::ceil(h / s));
  LatticeSums sums;
  for (int i = -reach; i <= reach; ++i) {
    for (int j = -reach; j <= reach; ++j) {
      for (int k = -reach; k <= reach; ++k) {
        const double r2 = s * s * (i * i + j * j + k * k), r = std::sqrt(r2);
        if (r >= h) continue;
        const double w = poly6 * std::pow(h * h - r2, 3);
        sums.weight += w;
        if (r == 0) continue;
        const double g = spiky * (h - r) * (h - r);
        sums.gradient += g * (k * s) * (k * s) / r;
        sums.gradient2 += g * g;
      }
    }
  }
  return sums;
}

}  // namespace

Kernel calibrate(double spacing, double support_radius) {
  const double h = support_radius;
  const LatticeSums sums = sum_over_lattice(spacing, h);
  const double volume = 1 / sums.weight;
  const double gradient = 1 / sums.gradient;
  Kernel k;
  k.h = static_cast<float>(h);
  k.h2 = static_cast<float>(h * h);
  k.volume = static_cast<float>(volume);
  k.poly6 = static_cast<float>(volume * 315 / (64 * std::numbers::pi * std::pow(h, 9)));
  k.spiky_gradient = static_cast<float>(gradient * 45 / (std::numbers::pi * std::pow(h, 6)));
  k.inverse_h2 = static_cast<float>(1 / (h * h));
  k.peak_weight = static_cast<float>(volume * 315 / (64 * std::numbers::pi * std::pow(h, 3)));
  k.peak_slope = static_cast<float>(gradient * 45 / (std::numbers::pi * std::pow(h, 4)));
  k.peak_pull = static_cast<float>(gradient * 45 / (std::numbers::pi * std::pow(h, 5)));
  k.rest_gradient2 = static_cast<float>(gradient * gradient * sums.gradient2);
  return k;
}

}  // namespace meniscus::fluid
