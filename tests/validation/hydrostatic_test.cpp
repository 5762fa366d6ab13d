// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The sample of a column of water, 40 layers deep, is at rest: its height, its pressure in each layer and its
// weight on the floor are those of hydrostatics, and little moves.
#include <numeric>

#include "sdk/scene/scene_file.h"
#include "tests/validation/measures.h"
#include "tests/validation/scenes.h"

namespace meniscus::tests {
namespace {

constexpr double gravity = 9.81, density = 1000;
constexpr double depth = 4, base = 1.6 * 1.6;  // m, m²
constexpr double spacing = 0.1, support = 0.2;
constexpr size_t layers = 40, in_layer = 256;

double rms_speed(const World& world) {
  double sum = 0;
  for (Vec3 v : world.velocities()) sum += dot(v, v);
  return std::sqrt(sum / static_cast<double>(world.particle_count()));
}

struct Layer {
  double height = 0, pressure = 0;
};

/// The particles from the lowest up, as many at a time as there were in a layer at the start: means of each.
std::vector<Layer> layers_of(const World& world) {
  std::vector<size_t> order(world.particle_count());
  std::iota(order.begin(), order.end(), size_t{0});
  const std::span<const Vec3> positions = world.positions();
  const std::span<const float> pressures = world.pressures();
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return positions[a].y < positions[b].y; });
  std::vector<Layer> found(layers);
  for (size_t k = 0; k < order.size(); ++k) {
    Layer& layer = found[k / in_layer];
    layer.height += positions[order[k]].y / in_layer;
    layer.pressure += pressures[order[k]] / in_layer;
  }
  return found;
}

/// Means of the layers over frames.
class LayerMeans {
 public:
  void add(const std::vector<Layer>& now) {
    for (size_t k = 0; k < layers; ++k) {
      sums_[k].height += now[k].height;
      sums_[k].pressure += now[k].pressure;
    }
    ++frames_;
  }

  /// Largest deviation from ρ·g·z, as a part of it, over the layers deeper than `from`. Just under the
  /// surface the pressure rises in steps of two layers: the gradient at a layer is made by those above and
  /// below it, and the top one has no pressure.
  double worst_pressure_error(double from) const {
    double worst = 0;
    for (const Layer& sum : sums_) {
      const double z = depth - sum.height / frames_;
      if (z > from) worst = std::max(worst, std::fabs(sum.pressure / frames_ / (density * gravity * z) - 1));
    }
    return worst;
  }

 private:
  std::vector<Layer> sums_{layers};
  double frames_ = 0;
};

class HydrostaticTest : public OnDevice {};

TEST_P(HydrostaticTest, ColumnIsAtRest) {
  Scene scene = read_scene(sample_scene("hydrostatic"));
  scene.world.device = choice_of(GetParam());
  BuiltScene built = build_scene(scene);
  World& world = built.world;
  ASSERT_EQ(world.particle_count(), layers * in_layer);
  record_device(world);
  size_t floor = 0;
  while (scene.probes.at(floor).def.name != "floor_force") ++floor;

  Watch watch(world);
  LayerMeans means;
  double height_error = 0, top_error = 0, speed = 0, force = 0, frames = 0;
  while (world.time() < 10) {
    world.step(frame_time);
    watch.add(world.diagnostics());
    if (world.time() < 8) continue;
    height_error = std::max(height_error, std::fabs(2 * mean_height(world) / depth - 1));
    const std::vector<Layer> now = layers_of(world);
    top_error = std::max(top_error, std::fabs((now.back().height + 0.5 * spacing) / depth - 1));
    speed = std::max(speed, rms_speed(world) / std::sqrt(gravity * depth));
    means.add(now);
    force += world.probe(built.probes[floor]);
    ++frames;
  }
  const double weight_error = std::fabs(force / frames / (density * gravity * depth * base) - 1);
  record("height_error_percent", 100 * height_error);
  record("top_error_percent", 100 * top_error);
  record("rms_speed_percent", 100 * speed);
  const double pressure_error = means.worst_pressure_error(1.5 * support);
  record("pressure_error_percent", 100 * pressure_error);
  record("pressure_error_near_surface_percent", 100 * means.worst_pressure_error(support));
  record("weight_error_percent", 100 * weight_error);
  watch.expect_sound();
  EXPECT_LE(height_error, 0.02);
  EXPECT_LE(top_error, 0.02);
  EXPECT_LE(speed, 0.01);
  EXPECT_LE(pressure_error, 0.05);
  EXPECT_LE(weight_error, 0.02);
}

MENISCUS_ON_EACH_DEVICE(HydrostaticTest);

}  // namespace
}  // namespace meniscus::tests
