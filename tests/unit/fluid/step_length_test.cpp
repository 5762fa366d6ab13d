// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Steps of different lengths, as the frames of a game have.
#include <gtest/gtest.h>

#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

class StepLengthTest : public OnDevice {
 protected:
  static WorldDef def() {
    WorldDef d = world_def(GetParam(), 0.05f);
    d.substeps = 1;
    return d;
  }
};

TEST_P(StepLengthTest, AlternatingStepsGainNoEnergy) {
  World world = dam_break(def());
  const double start = energy(world);
  for (int k = 0; k < 150; ++k) {
    world.step(k % 2 ? 0.006f : 0.001f);
    ASSERT_LE(energy(world), 1.03 * start) << "step " << k;
  }
  EXPECT_LT(world.diagnostics().max_speed, 8);
}

TEST_P(StepLengthTest, OneShortStepIsNoBlow) {
  World world = dam_break(def());
  run(world, 200, 0.004f);
  world.step(1e-4f);
  run(world, 5, 0.004f);
  EXPECT_LT(world.diagnostics().max_speed, 8);
  EXPECT_EQ(world.diagnostics().outside, 0u);
}

MENISCUS_ON_EACH_DEVICE(StepLengthTest);

}  // namespace
}  // namespace meniscus::tests
