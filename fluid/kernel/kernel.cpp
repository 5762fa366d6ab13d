// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Calibrates the smoothing kernels on a packing at rest.
#include "fluid/kernel/kernel.h"

#include <cmath>
#include <map>
#include <mutex>
#include <numbers>

#include "fluid/kernel/packing.h"
#include "fluid/kernel/tuning.h"

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

Kernel calibrate_on_lattice(double spacing, double h) {
  const LatticeSums sums = sum_over_lattice(spacing, h);
  const double volume = 1 / sums.weight;
  const double gradient = 1 / sums.gradient;
  Kernel k{};
  k.shape = SmoothingKernel::poly6_spiky;
  k.h = static_cast<float>(h);
  k.h2 = static_cast<float>(h * h);
  k.volume = k.particle_volume = k.slope_volume = static_cast<float>(volume);
  k.poly6 = static_cast<float>(volume * 315 / (64 * std::numbers::pi * std::pow(h, 9)));
  k.inverse_h2 = static_cast<float>(1 / (h * h));
  k.peak_weight = static_cast<float>(volume * 315 / (64 * std::numbers::pi * std::pow(h, 3)));
  k.peak_slope = static_cast<float>(gradient * 45 / (std::numbers::pi * std::pow(h, 4)));
  k.peak_pull = static_cast<float>(gradient * 45 / (std::numbers::pi * std::pow(h, 5)));
  k.greatest_slope = k.peak_slope;
  k.rest_gradient2 = static_cast<float>(gradient * gradient * sums.gradient2);
  return k;
}

/// What a relaxed packing gives, in spacings.
struct PackingCalibration {
  PackingSums sums;
  double spectral_radius;
};

/// Relaxing a packing takes up to half a second, so it is done once for each ratio.
PackingCalibration packing_calibration(SmoothingKernel shape, double ratio) {
  static std::mutex mutex;
  static std::map<std::pair<SmoothingKernel, double>, PackingCalibration> known;
  const std::scoped_lock lock(mutex);
  const auto found = known.find({shape, ratio});
  if (found != known.end()) return found->second;
  const ExactKernel kernel{shape, ratio};
  const Packing packing = relaxed_packing(kernel);
  return known[{shape, ratio}] = {sum_over(packing, kernel), spectral_radius(packing, kernel)};
}

/// A support ratio is a float, so that rounding of h makes no new ratio.
double ratio_of(double spacing, double h) {
  return double{static_cast<float>(h / spacing)};
}

/// slope_shape where it is greatest: Wendland's at q = ¼, the spline's at q = ⅓.
double greatest_slope_shape(SmoothingKernel shape) {
  return shape == SmoothingKernel::wendland_c2 ? 27.0 / 256 : 1.0 / 3;
}

Kernel calibrate_on_packing(double spacing, double h, SmoothingKernel shape) {
  const PackingCalibration packing = packing_calibration(shape, ratio_of(spacing, h));
  const double s3 = spacing * spacing * spacing;
  const double volume = s3 / packing.sums.weight, gradient = s3 / packing.sums.gradient;
  const double slope = gradient * (shape == SmoothingKernel::wendland_c2 ? 210 : 48) / std::numbers::pi;
  Kernel k{};
  k.shape = shape;
  k.h = static_cast<float>(h);
  k.h2 = static_cast<float>(h * h);
  k.volume = static_cast<float>(volume);
  k.particle_volume = static_cast<float>(s3);
  k.slope_volume = static_cast<float>(gradient);
  k.inverse_h2 = static_cast<float>(1 / (h * h));
  k.peak_weight = static_cast<float>(volume * ExactKernel{shape, h}.weight(0));
  k.peak_slope = static_cast<float>(slope / std::pow(h, 4));
  k.peak_pull = static_cast<float>(slope / std::pow(h, 5));
  k.greatest_slope = static_cast<float>(greatest_slope_shape(shape) * slope / std::pow(h, 4));
  k.rest_gradient2 =
      static_cast<float>(packing.sums.gradient2 / std::pow(packing.sums.gradient * spacing, 2));
  k.spectral_bound = static_cast<float>(kernel_tuning::spectral_margin * packing.spectral_radius);
  return k;
}

}  // namespace

KernelMoments moments_of(SmoothingKernel shape) {
  switch (shape) {
    case SmoothingKernel::wendland_c2:
      return {1.0 / 5, 3.0 / 2};
    case SmoothingKernel::cubic_spline:
      return {9.0 / 40, 7.0 / 5};
    case SmoothingKernel::poly6_spiky:
      break;
  }
  return {3.0 / 11, 315.0 / 256};
}

Kernel calibrate(double spacing, double support_radius, SmoothingKernel shape) {
  return shape == SmoothingKernel::poly6_spiky ? calibrate_on_lattice(spacing, support_radius)
                                               : calibrate_on_packing(spacing, support_radius, shape);
}

}  // namespace meniscus::fluid
