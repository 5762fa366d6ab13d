// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The sample of a column of water, 40 layers deep, is at rest: its height, its pressure in each layer and its
// weight on the floor are those of hydrostatics, and little moves.
#include "sdk/scene/scene_file.h"
#include "sdk/validation/cases/rest_column.h"
#include "tests/validation/measures.h"
#include "tests/validation/scenes.h"

namespace meniscus::tests {
namespace {

using validation::Layer;
using validation::LayerMeans;
using validation::layers_of;

constexpr double gravity = 9.81, density = 1000;
constexpr double depth = 4, base = 1.6 * 1.6;  // m, m²
constexpr double spacing = 0.1, support = 0.2;
constexpr size_t layers = 40, in_layer = 256;

double rms_speed(const World& world) {
  double sum = 0;
  for (Vec3 v : world.velocities()) sum += dot(v, v);
  return std::sqrt(sum / static_cast<double>(world.particle_count()));
}

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
  LayerMeans means(layers, depth);
  double height_error = 0, top_error = 0, speed = 0, force = 0, frames = 0;
  while (world.time() < 10) {
    world.step(frame_time);
    watch.add(world.diagnostics());
    if (world.time() < 8) continue;
    height_error = std::max(height_error, std::fabs(2 * mean_height(world) / depth - 1));
    const std::vector<Layer> now = layers_of(world, in_layer);
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
