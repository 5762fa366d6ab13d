// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Computes the points and weights of a density map's quadrature.
#include "collision/sdf/density_map_quadrature.h"
#include "collision/sdf/tuning.h"

#include <algorithm>
#include <cmath>

namespace meniscus::collision {

namespace {

// Variance, in squared steps, of the smoothing of a sample: of its fraction, and of two means over `width`
// samples.
double variance(uint32_t width) {
  const double w = width, mean = width % 2 ? (w * w - 1) / 12 : (w * w + 2) / 12;
  return 1.0 / 6 + 2 * mean;
}

// Weight and slope for a support radius of 1, without their constant. rr is the squared radius, k half of the
// variance.
double weight_at(double rr, double k) {
  const double a = 1 - rr;
  return a * a * a - k * 6 * a * (7 * rr - 3);
}
double slope_at(double rr, double k) {
  const double a = 1 - rr;
  return 6 * a * a + k * 12 * (10 - 14 * rr);
}

std::vector<QuadraturePoint> points_of(double step, uint32_t stride, double h) {
  const double spacing = stride * step / h, k = 0.5 * variance(stride) * step * step / (h * h);
  const int reach = static_cast<int>(1 / spacing), s = static_cast<int>(stride);
  std::vector<QuadraturePoint> points;
  double weights = 0, moments = 0;
  for (int z = -reach; z <= reach; ++z) {
    for (int y = -reach; y <= reach; ++y) {
      for (int x = -reach; x <= reach; ++x) {
        const double rr = (x * x + y * y + z * z) * spacing * spacing;
        if (rr >= 1) continue;
        const double weight = weight_at(rr, k), slope = slope_at(rr, k);
        points.push_back({s * x, s * y, s * z, static_cast<float>(weight), static_cast<float>(slope)});
        weights += weight;
        moments += slope * (s * x) * (s * x);
      }
    }
  }
  for (QuadraturePoint& p : points) {
    p.weight = static_cast<float>(p.weight / weights);
    p.slope = static_cast<float>(p.slope / (moments * step));  // so that linear fractions give their slope
  }
  return points;
}

}  // namespace

DensityQuadrature density_quadrature(float cell_size, float h, uint32_t most) {
  using namespace sdf_tuning;
  const double cells = std::max(1.0, static_cast<double>(h) / cell_size);
  const auto refinement = static_cast<uint32_t>(std::clamp(std::ceil(steps_a_radius / cells - step_rounding),
                                                           1.0, static_cast<double>(std::max(most, 1u))));
  const double samples = std::floor(cells * refinement / samples_a_radius + step_rounding);
  const auto stride = static_cast<uint32_t>(std::max(1.0, samples));
  const double step = static_cast<double>(cell_size) / refinement;
  return {refinement, stride, static_cast<float>(step), points_of(step, stride, h)};
}

}  // namespace meniscus::collision
