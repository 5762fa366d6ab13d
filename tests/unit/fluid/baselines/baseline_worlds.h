// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Small worlds for tests of the baselines.
#pragma once

#include <string>

#include "tests/worlds.h"

namespace meniscus::tests {

constexpr float baseline_spacing = 0.05f, baseline_frame = 1 / 60.0f;  // m, s
constexpr DensitySolver all_baselines[] = {DensitySolver::pcisph, DensitySolver::wcsph, DensitySolver::dfsph};

inline std::string name_of(DensitySolver solver) {
  return solver == DensitySolver::pcisph ? "pcisph" : solver == DensitySolver::wcsph ? "wcsph" : "dfsph";
}

inline WorldDef baseline_def(pbd::DeviceKind device, DensitySolver solver) {
  WorldDef def = world_def(device, baseline_spacing);
  def.density.solver = solver;
  return def;
}

inline void add_moving(World& world, FluidId fluid, const std::vector<Vec3>& positions, Vec3 velocity) {
  world.add_particles(fluid, positions, std::vector<Vec3>(positions.size(), velocity));
}

/// A pool of this depth and width, m, and its container.
struct Pool {
  World world;
  FluidId water{};
  ShapeId box{};

  Pool(const WorldDef& def, float depth, float width) : world(def) {
    FluidDef fluid;
    fluid.xsph = 5;
    water = world.create_fluid(fluid);
    box = world.create_shape(tank({0, 0, 0}, {width, 3 * depth, width}));
    world.add_fluid(block(water, {0, 0, 0}, {width, depth, width}));
  }
};

}  // namespace meniscus::tests
