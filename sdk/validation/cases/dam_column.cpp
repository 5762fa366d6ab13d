// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A column of water twice as high as it is wide collapses: its front on the floor and its height at the wall.
#include "sdk/validation/cases/dam_column.h"

#include <algorithm>
#include <cmath>

#include "sdk/validation/curves.h"
#include "sdk/validation/parts.h"

namespace meniscus::validation {
namespace {

double front_of(const World& world, float width) {
  std::vector<float> on_floor;
  for (Vec3 p : world.positions()) {
    if (p.y < world.support_radius()) on_floor.push_back(p.x);
  }
  return (percentile(on_floor, 0.99) + 0.5 * double{world.def().particle_spacing}) / double{width};
}

double height_of(const World& world, float width) {
  std::vector<float> at_wall;
  for (Vec3 p : world.positions()) {
    if (p.x < world.support_radius()) at_wall.push_back(p.y);
  }
  return (percentile(at_wall, 0.99) + 0.5 * double{world.def().particle_spacing}) / (2 * double{width});
}

}  // namespace

WorldDef column_world(const Settings& settings, float width, int across) {
  constexpr int across_a_substep = 5;
  WorldDef def = settings.world(width / float(across));
  def.substeps = std::max(def.substeps, across / across_a_substep);
  if (settings.resolution == Resolution::full) def.density.solver = DensitySolver::grid;
  return def;
}

DamMotion collapse(const DamColumn& column, double until) {
  const float a = column.width, depth = 0.4f * a;
  World world(column.world);
  world.create_shape(tank({0, 0, 0}, {column.length * a, 3 * a, depth}));
  world.add_fluid(block(world.create_fluid({}), {0, 0, 0}, {a, 2 * a, depth}));
  const double scale = std::sqrt(2 * 9.81 / double{a});
  const double time_scale = std::sqrt(double{a});  // Froude's similarity
  const auto step = static_cast<float>(0.016 * time_scale);
  DamMotion motion;
  motion.front.add(0, front_of(world, a));
  motion.height.add(0, height_of(world, a));
  while (motion.front.y.back() < until && world.time() < double{column.end_time} * time_scale) {
    world.step(step);
    const double time = world.time() * scale;
    motion.front.add(time, front_of(world, a));
    motion.height.add(time, height_of(world, a));
  }
  return motion;
}

const Curve& martin_moyce_front() {
  static const Curve readings{
      "Martin & Moyce 1952",
      {.41, .84, 1.19, 1.43, 1.63, 1.83, 1.98, 2.20, 2.32, 2.51, 2.65, 2.83, 2.98, 3.11, 3.33},
      {1.11, 1.22, 1.44, 1.67, 1.89, 2.11, 2.33, 2.56, 2.78, 3.00, 3.22, 3.44, 3.67, 3.89, 4.11},
      true};
  return readings;
}

const Curve& martin_moyce_height() {
  static const Curve readings = [] {
    Curve curve{"Martin & Moyce 1952",
                {.56, .93, 1.28, 1.66, 2.00, 2.45, 3.06, 4.20},  // τ = t √(g/a)
                {.94, .83, .72, .61, .50, .39, .28, .17},
                true};
    for (double& t : curve.x) t *= std::sqrt(2.0);
    return curve;
  }();
  return readings;
}

}  // namespace meniscus::validation
