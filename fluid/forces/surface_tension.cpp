// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Calibrates the surface tension forces on the rest lattice, so that tensions are in N/m.
#include "fluid/forces/surface_tension.h"
#include "fluid/forces/tuning.h"

#include <algorithm>
#include <cmath>

namespace meniscus::fluid {

namespace {

/// The sum of Kirkwood & Buff over the pairs at a flat surface of the rest lattice, N/m: Σ (r² − 3z²)/(2r) F,
/// per area. Beyond twice the reach, particles are as inside the fluid, where the terms cancel.
template <class F>
double flat_tension(double spacing, int reach, F force) {
  double sum = 0;
  for (int layer = 0; layer <= 2 * reach; ++layer) {
    for (int i = -reach; i <= reach; ++i) {
      for (int j = -reach; j <= reach; ++j) {
        for (int k = -reach; k <= std::min(layer, reach); ++k) {
          if (i == 0 && j == 0 && k == 0) continue;
          const double r = spacing * std::sqrt(double(i * i + j * j + k * k)), z = spacing * k;
          sum += 0.5 * (r * r - 3 * z * z) / (2 * r) * force(r);  // a pair counts half at either end
        }
      }
    }
  }
  return sum / (spacing * spacing);
}

}  // namespace

// The curvature term in the continuum: Σ V W (n_j − n_i) is (m h²/6) ∇²n, where m h² is W's second moment. So
// the force is that of Korteweg's stress, (B m h³/6V) ∇∇²φ. Integrated into a ball it gives 2σ/R with σ = (B
// m h³/12V) |φ'|, where φ' = −edge/h is the slope of the smoothed edge. V is a particle's volume. Sums with
// another volume exceed the integrals by `fill` and `slope_fill`. The measured period of a drop shows a
// tension that differs from the one asked for, by the same factor for both terms. Both are divided by that.
TensionKernel calibrate_tension(const Kernel& kernel, double spacing) {
  const double measured_over_asked = forces_tuning::measured_over_asked(kernel.shape);
  const KernelMoments moments = moments_of(kernel.shape);
  const double h = kernel.h;
  TensionKernel t{kernel.h, static_cast<float>(4 / (h * h)), 1, 1};
  const double cohesion = flat_tension(spacing, static_cast<int>(std::ceil(h / spacing)),
                                       [&](double r) { return t.attraction(static_cast<float>(r)); });
  const double fill = kernel.volume / kernel.particle_volume;
  const double slope_fill = kernel.slope_volume / kernel.particle_volume;
  const double curvature =
      h * h / (12 / moments.second * kernel.particle_volume) * moments.edge * fill * slope_fill;
  t.cohesion_scale = static_cast<float>(1 / (measured_over_asked * cohesion));
  t.curvature_scale = static_cast<float>(1 / (measured_over_asked * curvature));
  return t;
}

Affinity affinity_of(const Material& m) {
  return {std::sqrt(m.cohesion + 0.5f * m.surface_tension), std::sqrt(0.5f * m.surface_tension)};
}

}  // namespace meniscus::fluid
