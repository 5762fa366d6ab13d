// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A column of water at rest: its pressure, its weight on the floor, its level and how calm it is.
#include <algorithm>
#include <cmath>

#include "sdk/validation/cases/cases.h"
#include "sdk/validation/cases/rest_column.h"
#include "sdk/validation/parts.h"

namespace meniscus::validation {
namespace {

constexpr double weight_density = 1000 * 9.81;  // N/m³

struct Column {
  float spacing;
  int layers, across;  ///< spacings

  float depth() const { return float(layers) * spacing; }
  float half() const { return 0.5f * float(across) * spacing; }
};

World column_world(const Settings& settings, const Column& column, ProbeId& floor_force) {
  World world(settings.world(column.spacing));
  const float depth = column.depth(), half = column.half();
  const ShapeId floor = world.create_shape(shape(PlaneGeometry{}));
  ShapeDef walls = tank({-half, -1, -half}, {half, 2 * depth, half});
  std::get<ContainerGeometry>(walls.geometry).openings = {{Face::y_high, {}}};
  world.create_shape(walls);
  FluidDef water;
  water.xsph = 100;
  world.add_fluid(block(world.create_fluid(water), {-half, 0, -half}, {half, depth, half}));
  ProbeDef probe;
  probe.kind = ProbeKind::wall_force;
  probe.shape = floor;
  floor_force = world.create_probe(probe);
  return world;
}

double rms_speed(const World& world) {
  double sum = 0;
  for (Vec3 v : world.velocities()) sum += double{v.x * v.x + v.y * v.y + v.z * v.z};
  return std::sqrt(sum / static_cast<double>(world.particle_count()));
}

Plot pressure_plot(const LayerMeans& means, double depth) {
  Curve measured{"layers", {}, {}, true}, exact{"ρ g z"};
  const std::vector<Layer> layers = means.means();
  for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer) {
    const double z = depth - layer->height;
    measured.add(z, layer->pressure);
    exact.add(z, weight_density * z);
  }
  return {"Pressure in the column", "depth (m)", "pressure (Pa)", {exact, measured}};
}

Result result_of(const Settings& settings) {
  const Column column = settings.choose(Column{0.1f, 20, 8}, Column{0.1f, 40, 16}, Column{0.05f, 80, 32});
  const double depth = double{column.depth()}, width = 2 * double{column.half()};
  const double until = settings.choose(6, 10, 10);
  // At quick resolution two layers are a large part of the depth. At full resolution the column sinks by a
  // spacing, and depths are those below its level at the start.
  const Bar bar = settings.resolution == Resolution::medium ? Bar::hard : Bar::target;
  ProbeId floor;
  World world = column_world(settings, column, floor);
  LayerMeans means(static_cast<std::size_t>(column.layers), depth);
  double force = 0, level = 0, speed = 0, frames = 0;
  while (world.time() < until) {
    world.step(0.016f);
    if (world.time() < until - 2) continue;
    const std::vector<Layer> now =
        layers_of(world, static_cast<std::size_t>(column.across) * static_cast<std::size_t>(column.across));
    means.add(now);
    force += world.probe(floor);
    level += now.back().height + 0.5 * double{column.spacing};
    speed = std::max(speed, rms_speed(world) / std::sqrt(9.81 * depth));
    ++frames;
  }
  Result result;
  const double pressure_error = 100 * means.worst_pressure_error(3 * double{column.spacing});
  const char* steps =
      "The pressure rises in steps of two layers while the water still lies in its lattice. With 80 layers "
      "the column also sinks by a spacing, and depths are those below its level at the start.";
  result.at_most("pressure, worst layer, relative error", "%", pressure_error, 5, bar, steps);
  result.at_most("pressure, worst layer, relative error", "%", pressure_error, 2, Bar::target, steps);
  const double weight_error = 100 * (force / frames / (weight_density * depth * width * width) - 1);
  result.about_zero("force on the floor over the weight less 1", "%", weight_error, 1, Bar::hard);
  result.about_zero("level over that of the volume less 1", "%", 100 * (level / frames / depth - 1), 2,
                    Bar::hard);
  result.at_most("RMS speed over √(g H)", "%", 100 * speed, 1, Bar::hard);
  result.plots = {pressure_plot(means, depth)};
  return result;
}

}  // namespace

Case hydrostatics() {
  return {
      "hydrostatics", "Water at rest: pressure, weight and level",
      "A column of water comes to rest between smooth walls, with xsph at 100 1/s. Figures are means over "
      "the last 2 s, and the largest speed in them. Pressures are those of layers that are deeper than "
      "three spacings.",
      "Hydrostatics: p = ρ g z; the floor bears the weight.", result_of};
}

}  // namespace meniscus::validation
