// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The density solve ends where its error is small enough: what it keeps, what it saves, and that a tolerance
// that is never met changes nothing.
#include <gtest/gtest.h>

#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

constexpr float frame = 0.016f;

class DensityToleranceTest : public OnDevice {
 protected:
  static WorldDef def(float tolerance, int iterations, float spacing = 0.05f) {
    WorldDef d = world_def(GetParam(), spacing);
    d.iterations = iterations;
    d.density.tolerance = tolerance;
    return d;
  }

  /// Ten layers at rest.
  static World calm(const WorldDef& d) {
    World world(d);
    world.create_shape(tank({0, 0, 0}, {0.8f, 1, 0.8f}));
    world.add_fluid(block(world.create_fluid({}), {0, 0, 0}, {0.8f, 0.5f, 0.8f}));
    run(world, 40, frame);
    return world;
  }
};

TEST_P(DensityToleranceTest, CalmWaterTakesFewIterationsAndKeepsTheTolerance) {
  for (float tolerance : {2e-3f, 5e-4f}) {
    SCOPED_TRACE(tolerance);
    World world = calm(def(tolerance, 30));
    double most = 0;
    for (int k = 0; k < 20; ++k) {
      most = std::max(most, world.step(frame).density_iterations);
      EXPECT_LT(world.diagnostics().density_error_mean, 1.05 * double{tolerance});
    }
    EXPECT_GE(most, 1);
    EXPECT_LT(most, 10);
    EXPECT_EQ(world.diagnostics().outside, 0u);
  }
}

TEST_P(DensityToleranceTest, ATighterOneTakesMore) {
  World loose = calm(def(2e-3f, 30)), tight = calm(def(1e-4f, 30));
  EXPECT_LT(loose.step(frame).density_iterations + 0.9, tight.step(frame).density_iterations);
}

TEST_P(DensityToleranceTest, AfterAPressureGridThereMayBeNone) {
  WorldDef d = def(3e-3f, 20);
  d.density.solver = DensitySolver::grid;
  World world = calm(d);
  for (int k = 0; k < 20; ++k) {
    EXPECT_LT(world.step(frame).density_iterations, 1);
    EXPECT_LT(world.diagnostics().density_error_mean, 3.15e-3);
  }
}

TEST_P(DensityToleranceTest, WhatIsNeverMetChangesNoBits) {
  WorldDef d = def(0, 6);
  World without = dam_break(d);
  d.density.tolerance = 1e-30f;
  World with = dam_break(d);
  for (int k = 0; k < 30; ++k) {
    without.step(frame);
    EXPECT_EQ(with.step(frame).density_iterations, 6);
  }
  EXPECT_EQ(without.state_hash(), with.state_hash());
}

TEST_P(DensityToleranceTest, EachNumberOfThreadsGivesTheSameBits) {
  uint64_t hashes[3];
  double iterations[3];
  for (int k = 0; k < 3; ++k) {
    WorldDef d = def(1e-3f, 20);
    d.threads = 1 + k;
    World world = dam_break(d);
    run(world, 30, frame);
    iterations[k] = world.step(frame).density_iterations;
    hashes[k] = world.state_hash();
  }
  for (int k : {1, 2}) {
    EXPECT_EQ(hashes[0], hashes[k]);
    EXPECT_EQ(iterations[0], iterations[k]);
  }
}

TEST_P(DensityToleranceTest, ARunningWorldCanTakeItOnAndDropIt) {
  World world = calm(def(0, 12));
  EXPECT_EQ(world.step(frame).density_iterations, 12);
  world.set_def(def(1e-3f, 12));
  EXPECT_LT(world.step(frame).density_iterations, 12);
  world.set_def(def(0, 12));
  EXPECT_EQ(world.step(frame).density_iterations, 12);
}

// What is not done must not be paid for: of a hundred iterations a few are left. A GPU needs work to do, else
// launches are all that there is.
TEST_P(DensityToleranceTest, TheSolveTakesLessTime) {
  const auto solve_ms = [](World& world) {
    double least = 1e9;
    for (int k = 0; k < 5; ++k)
      least = std::min(least, world.step(frame).stage_ms[static_cast<size_t>(Stage::solve)]);
    return least;
  };
  const float spacing = GetParam() == pbd::DeviceKind::cuda ? 0.01f : 0.05f;
  World world = calm(def(1e-3f, 12, spacing));
  world.set_def(def(1e-3f, 100, spacing));
  const double with = solve_ms(world);
  world.set_def(def(0, 100, spacing));
  EXPECT_LT(with, 0.5 * solve_ms(world));
}

MENISCUS_ON_EACH_DEVICE(DensityToleranceTest);

}  // namespace
}  // namespace meniscus::tests
