// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The initial multipliers of the density solve, where substeps are long.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

class DensityStartTest : public OnDevice {};

/// In a 60th of a second gravity alone moves a particle by a tenth of a spacing, and forty layers press.
TEST_P(DensityStartTest, DeepWaterStaysCalmInLongSubsteps) {
  WorldDef def = world_def(GetParam(), 0.025f);
  def.substeps = 1;
  def.iterations = 8;
  def.density.spectral_bound = 9;  // water that is pressed together needs more than the default
  World world(def);
  world.create_shape(tank({0, 0, 0}, {0.3f, 2, 0.3f}));
  world.add_fluid(block(world.create_fluid({}), {0, 0, 0}, {0.3f, 1, 0.3f}));
  run(world, 90, 1 / 60.0f);
  double sum = 0;
  for (const Vec3& v : world.velocities()) sum += double{dot(v, v)};
  EXPECT_LT(std::sqrt(sum / static_cast<double>(world.particle_count())), 0.3);
}

MENISCUS_ON_EACH_DEVICE(DensityStartTest);

}  // namespace
}  // namespace meniscus::tests
