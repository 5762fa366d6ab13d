// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Measures a column of water at rest, layer by layer.
#include "sdk/validation/cases/rest_column.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace meniscus::validation {

std::vector<Layer> layers_of(const World& world, std::size_t in_layer) {
  std::vector<std::size_t> order(world.particle_count());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const std::span<const Vec3> positions = world.positions();
  const std::span<const float> pressures = world.pressures();
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return positions[a].y < positions[b].y; });
  std::vector<Layer> found(order.size() / in_layer);
  for (std::size_t k = 0; k < found.size() * in_layer; ++k) {
    Layer& layer = found[k / in_layer];
    layer.height += double{positions[order[k]].y} / static_cast<double>(in_layer);
    layer.pressure += double{pressures[order[k]]} / static_cast<double>(in_layer);
  }
  return found;
}

void LayerMeans::add(const std::vector<Layer>& now) {
  for (std::size_t k = 0; k < sums_.size(); ++k) {
    sums_[k].height += now[k].height;
    sums_[k].pressure += now[k].pressure;
  }
  ++frames_;
}

std::vector<Layer> LayerMeans::means() const {
  std::vector<Layer> means = sums_;
  for (Layer& layer : means) layer = {layer.height / frames_, layer.pressure / frames_};
  return means;
}

double LayerMeans::worst_pressure_error(double from) const {
  double worst = 0;
  for (const Layer& layer : means()) {
    const double z = depth_ - layer.height;
    if (z > from) worst = std::max(worst, std::fabs(layer.pressure / (1000 * 9.81 * z) - 1));
  }
  return worst;
}

}  // namespace meniscus::validation
