// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Small worlds for tests.
#pragma once

#include <meniscus/meniscus.h>

#include <random>
#include <vector>

#include "pbd/math/vec.h"
#include "sdk/validation/parts.h"
#include "tests/devices.h"

namespace meniscus::tests {

inline WorldDef world_def(pbd::DeviceKind device, float spacing) {
  WorldDef def;
  def.device = choice_of(device);
  def.particle_spacing = spacing;
  return def;
}

using validation::block;
using validation::shape;
using validation::tank;

/// A rotation by `degrees` about the z axis.
inline Quat about_z(float degrees) {
  const float half = 0.5f * degrees * 3.14159265f / 180;
  return {0, 0, std::sin(half), std::cos(half)};
}

inline std::vector<Vec3> lattice(int nx, int ny, int nz, float spacing, Vec3 lower) {
  std::vector<Vec3> points;
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        points.push_back(lower + spacing * Vec3{float(i) + 0.5f, float(j) + 0.5f, float(k) + 0.5f});
      }
    }
  }
  return points;
}

inline Vec3 random_vector(std::mt19937& random, float magnitude) {
  std::uniform_real_distribution<float> range(-magnitude, magnitude);
  const float x = range(random), y = range(random), z = range(random);
  return {x, y, z};
}

inline void run(World& world, int steps, float dt) {
  for (int k = 0; k < steps; ++k) world.step(dt);
}

/// N, on average over `steps` steps: what presses on a tank's floor, which is at y = 0.
inline double mean_force_on_floor(World& world, ShapeId box, int settle, int steps, float dt) {
  ProbeDef floor;
  floor.kind = ProbeKind::wall_force;
  floor.shape = box;
  floor.patch = Aabb{{-10, -0.01f, -10}, {10, 0.01f, 10}};
  const ProbeId probe = world.create_probe(floor);
  run(world, settle, dt);
  double force = 0;
  for (int k = 0; k < steps; ++k) {
    world.step(dt);
    force += double{world.probe(probe)} / steps;
  }
  return force;
}

inline double mean_height(const World& world) {
  double sum = 0;
  for (Vec3 p : world.positions()) sum += p.y;
  return sum / static_cast<double>(world.particle_count());
}

inline double energy(const World& world) {
  const Diagnostics d = world.diagnostics();
  return d.kinetic_energy + d.potential_energy;
}

/// A tank of 1 × 1 × 0.5 m with a block of water in its left half: the usual dam break, about `1 / s³ / 4`
/// particles.
inline World dam_break(const WorldDef& def) {
  World world(def);
  const FluidId water = world.create_fluid({});
  world.create_shape(tank({0, 0, 0}, {1, 1, 0.5f}));
  world.add_fluid(block(water, {0, 0, 0}, {0.5f, 0.8f, 0.5f}));
  return world;
}

inline World dam_break(pbd::DeviceKind device, float spacing = 0.05f) {
  return dam_break(world_def(device, spacing));
}

}  // namespace meniscus::tests
