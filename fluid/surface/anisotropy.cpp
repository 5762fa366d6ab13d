// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Calibrates the sizes of the ellipsoids on the cubic lattice.
#include "fluid/surface/anisotropy.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace meniscus::fluid {
namespace {

/// The results of Anisotropy `layer` layers below the flat surface of the cubic lattice with spacing 1.
struct Layer {
  double weight = 1;  // Σ w
  double mean = 0;    // of the height
  double radius = 1;  // upwards, of an ellipsoid of unit volume
};

Layer measure_layer(int layer, double support) {
  const int reach = static_cast<int>(std::ceil(support));
  double weight = 0, mean = 0, along = 0, up = 0;
  for (int x = -reach; x <= reach; ++x) {
    for (int y = -reach; y <= std::min(reach, layer); ++y) {
      for (int z = -reach; z <= reach; ++z) {
        const double r = std::sqrt(x * x + y * y + z * z);
        const double w = std::max(0.0, 1 - std::pow(r / support, 3));
        weight += w;
        mean += w * y;
        along += w * x * x;
        up += w * y * y;
      }
    }
  }
  mean /= weight;
  const double vertical = up / weight - mean * mean, horizontal = along / weight;
  return {weight, mean, std::pow(vertical / horizontal, 1.0 / 3)};
}

}  // namespace

AnisotropyParameters calibrate_anisotropy(double spacing, double support_radius) {
  AnisotropyParameters p;
  const double support = support_radius / spacing;
  // The surface is the highest top of any layer's ellipsoids.
  double radius = 1e30;
  for (int layer = 0; layer <= static_cast<int>(support); ++layer) {
    const Layer l = measure_layer(layer, support);
    radius = std::min(radius, (layer + 0.5 - double{p.smoothing} * l.mean) / l.radius);
  }
  p.support = static_cast<float>(support_radius);
  p.radius = static_cast<float>(radius * spacing);
  p.lone_radius = static_cast<float>(std::cbrt(0.75 / std::numbers::pi) * spacing);
  p.grain_radius = static_cast<float>(0.5 * spacing);
  p.surface_weight = static_cast<float>(measure_layer(0, support).weight);
  return p;
}

}  // namespace meniscus::fluid
