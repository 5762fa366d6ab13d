// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Validation: no particle ends inside a box when a dam break piles boxes up.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

class BoxesInDamTest : public OnDevice {};

// 100,000 particles carry a thousand boxes into the far end of the tank, and pile them up there. What is
// caught between boxes, a wall and the floor has nowhere to go: it must hold the pile apart, and not end in a
// box.
TEST_P(BoxesInDamTest, NothingEndsInABox) {
  constexpr float s = 0.05f, edge = 3 * s, pitch = 4 * s;
  constexpr int steps = 420, boxes = 1000, along = 25, across = 12;
  const Vec3 water{50 * s, 40 * s, 50 * s};
  WorldDef def = world_def(GetParam(), s);
  def.substeps = 1;
  def.iterations = 4;
  def.density.solver = DensitySolver::chebyshev;
  World world(def);
  world.create_shape(tank({0, 0, 0}, {3 * water.x, 2 * water.y, water.z}));
  world.add_fluid(block(world.create_fluid(FluidDef{}), {0, 0, 0}, water));
  BodyDef box;
  box.geometry = BoxGeometry{{edge / 2, edge / 2, edge / 2}};
  for (int k = 0; k < boxes; ++k) {
    box.pose.position = {water.x + (float(k % along) + 0.5f) * pitch,
                         (float(k / (along * across)) + 0.5f) * pitch,
                         (float(k / along % across) + 0.5f) * pitch};
    world.create_body(box);
  }
  const float dt = 0.2f * world.support_radius() / std::sqrt(2 * 9.81f * water.y);
  std::size_t outside = 0;
  for (int k = 0; k < steps; ++k) {
    world.step(dt);
    if (k % 5 == 4) outside = std::max(outside, world.diagnostics().outside);
  }
  EXPECT_EQ(outside, 0u);
}

MENISCUS_ON_EACH_DEVICE(BoxesInDamTest);

}  // namespace
}  // namespace meniscus::tests
