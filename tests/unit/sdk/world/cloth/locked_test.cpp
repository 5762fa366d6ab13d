// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cloth that an impact has crumpled comes free again.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/cloth_worlds.h"

namespace meniscus::tests {
namespace {

class LockedCloth : public OnDevice {};
MENISCUS_ON_EACH_DEVICE(LockedCloth);

/// A vertical sheet that falls on its lower edge. The impact presses its rows together in their own plane.
TEST_P(LockedCloth, ASheetDroppedOnItsEdgeCollapsesAndComesToRest) {
  WorldDef def = world_def(GetParam(), 0.05f);
  def.substeps = 4;
  def.iterations = 10;
  World world(def);
  ShapeDef floor = shape(PlaneGeometry{});
  floor.surface.friction = 0.5f;
  world.create_shape(floor);
  ClothDef vertical = sheet(0.2f, 0.2f, 21, 21, {0, 0.3f, 0});
  vertical.pose.rotation = {0.70710678f, 0, 0, 0.70710678f};
  const ClothId cloth = world.create_cloth(vertical);

  for (int frame = 0; frame < 60; ++frame) world.step(1 / 60.0f);

  float highest = 0, squares = 0;
  for (const Vec3& x : copy_of(world.cloth_positions(cloth))) highest = std::max(highest, x.y);
  const std::vector<Vec3> velocities = copy_of(world.cloth_velocities(cloth));
  for (const Vec3& v : velocities) squares += dot(v, v);
  EXPECT_LT(highest, 0.03f);  // locked, it stands 0.1 m high
  EXPECT_LT(std::sqrt(squares / static_cast<float>(velocities.size())), 0.03f);
  EXPECT_LT(world.cloth_state(cloth).max_stretch, 1.05f);  // locked, 1.39
  EXPECT_EQ(world.step(1 / 60.0f).overflows.cloth_failsafe, 0u);
}

}  // namespace
}  // namespace meniscus::tests
