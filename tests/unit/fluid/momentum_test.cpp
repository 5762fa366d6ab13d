// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Momentum and energy of fluids that nothing touches.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

constexpr float s = 0.05f;

struct Sums {
  double x = 0, y = 0, z = 0, magnitude = 0;  // kg m/s
};

class MomentumTest : public OnDevice {
 protected:
  /// Two blocks of shaken particles that fly through one another, of the fluids in turn.
  static void add_blocks(World& world, const std::vector<FluidId>& fluids) {
    std::mt19937 random(21);
    for (float side : {-1.0f, 1.0f}) {
      for (size_t f = 0; f < fluids.size(); ++f) {
        std::vector<Vec3> positions, velocities;
        for (Vec3 p : lattice(5, 10, 10, s, {side * 0.15f - 0.125f, -0.25f, -0.25f})) {
          if (static_cast<size_t>(random() % fluids.size()) != f) continue;
          positions.push_back(p + random_vector(random, 0.2f * s));
          velocities.push_back(Vec3{-side, 0, 0} + random_vector(random, 0.5f));
        }
        world.add_particles(fluids[f], positions, velocities);
      }
    }
  }

  static Sums momentum(const World& world, const std::vector<FluidId>& fluids) {
    Sums sums;
    for (size_t i = 0; i < world.particle_count(); ++i) {
      const double mass = world.particle_mass(fluids[world.fluids()[i]]);
      const Vec3 v = world.velocities()[i];
      sums.x += mass * v.x;
      sums.y += mass * v.y;
      sums.z += mass * v.z;
      sums.magnitude += mass * length(v);
    }
    return sums;
  }

  /// To the rounding of positions, which a step of this length turns into 1e-5 m/s a particle at most.
  static void expect_kept(World& world, const std::vector<FluidId>& fluids) {
    add_blocks(world, fluids);
    const Sums before = momentum(world, fluids);
    run(world, 200, 0.005f);
    const Sums after = momentum(world, fluids);
    EXPECT_NEAR((after.x - before.x) / before.magnitude, 0, 1e-5);
    EXPECT_NEAR((after.y - before.y) / before.magnitude, 0, 1e-5);
    EXPECT_NEAR((after.z - before.z) / before.magnitude, 0, 1e-5);
    EXPECT_LT(after.magnitude, before.magnitude);
  }

  WorldDef in_space() const {
    WorldDef def = world_def(GetParam(), s);
    def.gravity = {0, 0, 0};
    def.substeps = 1;
    return def;
  }
};

TEST_P(MomentumTest, OneFluidKeepsIt) {
  for (DensitySolver solver : {DensitySolver::jacobi, DensitySolver::chebyshev}) {
    WorldDef def = in_space();
    def.density.solver = solver;
    World world(def);
    FluidDef fluid;
    fluid.xsph = 0;
    expect_kept(world, {world.create_fluid(fluid)});
  }
}

TEST_P(MomentumTest, TwoFluidsOfDifferentDensityKeepIt) {
  World world(in_space());
  FluidDef heavy, light;
  heavy.xsph = 10;
  light.rest_density = 100;
  light.xsph = 3;
  light.dynamic_viscosity = 10;
  const FluidId a = world.create_fluid(heavy), b = world.create_fluid(light);
  expect_kept(world, {a, b});
}

TEST_P(MomentumTest, ArtificialPressureKeepsIt) {
  WorldDef def = in_space();
  def.density.artificial_pressure.strength = 0.1f;
  World world(def);
  expect_kept(world, {world.create_fluid({})});
}

TEST_P(MomentumTest, FreeFallIsExact) {
  WorldDef def = world_def(GetParam(), s);
  World world(def);
  world.add_particles(world.create_fluid({}), lattice(6, 6, 6, s, {-0.15f, -0.15f, -0.15f}));
  run(world, 50, 0.01f);
  for (Vec3 v : world.velocities()) {
    EXPECT_NEAR(v.y, -9.81f * 0.5f, 2e-3f);
    EXPECT_NEAR(v.x, 0, 2e-3f);
  }
}

TEST_P(MomentumTest, ALatticeAtRestStaysAtRest) {
  WorldDef def = in_space();
  World world(def);
  const std::vector<Vec3> points = lattice(8, 8, 8, s, {-0.2f, -0.2f, -0.2f});
  world.add_particles(world.create_fluid({}), points);
  run(world, 50, 0.01f);
  for (size_t i = 0; i < points.size(); ++i) {
    EXPECT_LT(length(world.positions()[i] - points[i]), 0.01f * s);
  }
}

MENISCUS_ON_EACH_DEVICE(MomentumTest);

}  // namespace
}  // namespace meniscus::tests
