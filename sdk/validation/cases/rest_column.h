// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Measures a column of water at rest, layer by layer.
#pragma once

#include <meniscus/world.h>

#include <vector>

namespace meniscus::validation {

struct Layer {
  double height = 0;    ///< m
  double pressure = 0;  ///< Pa
};

/// The particles from the lowest up, as many at a time as there were in a layer at the start: means of each.
std::vector<Layer> layers_of(const World& world, std::size_t in_layer);

/// Means of the layers over frames.
class LayerMeans {
 public:
  LayerMeans(std::size_t layers, double depth) : sums_(layers), depth_(depth) {}

  void add(const std::vector<Layer>& now);
  std::vector<Layer> means() const;
  /// Largest deviation from ρ g z of water, as a part of it, over the layers deeper than `from`. Just under
  /// the surface the pressure rises in steps of two layers: the gradient at a layer is made by those above
  /// and below it, and the top one has no pressure.
  double worst_pressure_error(double from) const;

 private:
  std::vector<Layer> sums_;
  double depth_, frames_ = 0;
};

}  // namespace meniscus::validation
