// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of artificial pressure.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

class ArtificialPressureTest : public OnDevice {
 protected:
  /// The root mean square distance from the centre, in spacings, of a ball of fluid after 40 steps. A step is
  /// as long as gravity takes for a fixed fraction of a spacing.
  double spread(float spacing, float strength, int substeps = 4, int iterations = 10) const {
    WorldDef def = world_def(GetParam(), spacing);
    def.gravity = {0, 0, 0};
    def.substeps = substeps;
    def.iterations = iterations;
    def.density.artificial_pressure.strength = strength;
    World world(def);
    FluidVolumeDef ball;
    ball.fluid = world.create_fluid({});
    ball.region = BallRegion{5 * spacing};
    world.add_fluid(ball);
    run(world, 40, 0.05f * std::sqrt(spacing));
    double sum = 0;
    for (Vec3 p : world.positions()) sum += dot(p, p);
    return std::sqrt(sum / static_cast<double>(world.particle_count())) / spacing;
  }
};

TEST_P(ArtificialPressureTest, ItSpreadsAFluidInProportion) {
  const double without = spread(0.05f, 0), some = spread(0.05f, 0.01f), more = spread(0.05f, 0.1f);
  EXPECT_GT(some, 1.0005 * without);
  EXPECT_GT(more, some);
  EXPECT_LT(more, 2 * without);
}

TEST_P(ArtificialPressureTest, ItDoesNotDependOnTheScale) {
  const double usual = spread(0.05f, 0.1f);
  EXPECT_NEAR(spread(0.005f, 0.1f) / usual, 1, 0.01);
  EXPECT_NEAR(spread(0.5f, 0.1f) / usual, 1, 0.01);
}

TEST_P(ArtificialPressureTest, NorOnTheStepOrTheIterations) {
  const double usual = spread(0.05f, 0.1f);
  EXPECT_NEAR(spread(0.05f, 0.1f, 8) / usual, 1, 0.03);
  EXPECT_NEAR(spread(0.05f, 0.1f, 4, 20) / usual, 1, 0.03);
}

MENISCUS_ON_EACH_DEVICE(ArtificialPressureTest);

}  // namespace
}  // namespace meniscus::tests
