// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A column of water that comes to rest after it was stirred.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/worlds.h"

namespace meniscus::tests {

struct RestCase {
  SmoothingKernel kernel = SmoothingKernel::wendland_c2;
  float support_ratio = 2;
  int substeps = 4;
  float height = 1, width = 0.5f;  ///< m
  float stir = 1;                  ///< m/s, the greatest of each component of the first velocities
  float seconds = 5;
};

struct RestMeasure {
  double rms = 0;       ///< over √(g H), in the last second
  double level = 0;     ///< twice the mean height, over H
  double pressure = 0;  ///< at half of the height, over ρ g (H/2), mean of the last second
};

inline RestMeasure come_to_rest(pbd::DeviceKind device, const RestCase& c) {
  WorldDef def = world_def(device, 0.05f);
  def.kernel = c.kernel;
  def.support_ratio = c.support_ratio;
  def.substeps = c.substeps;
  World world(def);
  world.create_shape(tank({0, 0, 0}, {c.width, 2 * c.height, c.width}));
  const FluidId water = world.create_fluid({.xsph = 0});
  world.add_fluid({.fluid = water,
                   .region = BoxRegion{{0, 0, 0}, {c.width, c.height, c.width}},
                   .seeding = Seeding::disordered});
  const ProbeId middle =
      world.create_probe({.name = "middle", .point = {0.5f * c.width, 0.5f * c.height, 0.5f * c.width}});
  std::mt19937 random(5);
  std::vector<Vec3> impulses;
  for (size_t i = 0; i < world.particle_count(); ++i)
    impulses.push_back(random_vector(random, c.stir * world.particle_mass(water)));
  const std::vector<ParticleId> ids(world.ids().begin(), world.ids().end());
  world.apply_impulses(ids, impulses);
  RestMeasure measure;
  const int frames = static_cast<int>(60 * c.seconds);
  for (int frame = 0; frame < frames; ++frame) {
    world.step(1.0f / 60);
    if (frame < frames - 60) continue;
    double square = 0, height = 0;
    for (Vec3 v : world.velocities()) square += dot(v, v);
    for (Vec3 p : world.positions()) height += p.y;
    const auto count = static_cast<double>(world.particle_count());
    measure.rms += square / count / 60;
    measure.level += 2 * height / count / c.height / 60;
    measure.pressure += world.probe(middle) / (1000 * 9.81 * 0.5 * c.height) / 60;
  }
  measure.rms = std::sqrt(measure.rms / (9.81 * c.height));
  return measure;
}

}  // namespace meniscus::tests
