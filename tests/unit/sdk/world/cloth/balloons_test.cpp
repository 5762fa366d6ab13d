// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Gas in closed cloth keeps its volume or its pressure, as its air lets it, and escapes through a tear.
#include <gtest/gtest.h>

#include "tests/cloth_worlds.h"
#include "tests/unit/sdk/world/solids/body_worlds.h"

namespace meniscus::tests {
namespace {

class BalloonTest : public OnDevice {
 protected:
  World world_{balloon_def()};

  WorldDef balloon_def() const {
    WorldDef def = weightless(GetParam());
    def.substeps = 8;
    def.iterations = 4;
    return def;
  }

  ClothDef balloon(float stiffness, float pressure) const {
    ClothDef def;
    def.name = "balloon";
    def.geometry = ClothSphere{0.25f, 6};
    def.fabric.warp_stiffness = def.fabric.weft_stiffness = stiffness;
    def.fabric.shear_stiffness = 0.5f * stiffness;
    def.inflation = InflationDef{pressure, 101325};
    return def;
  }
};

// A membrane of stiffness k along its edges under an overpressure p: p = 2 T / r with T = 1.5 k ε, as
// Poisson's ratio of a net of equilateral triangles is 1/3. The gas follows Boyle and Mariotte near the
// volume that it would fill.
TEST_P(BalloonTest, SkinAndGasAreInBalance) {
  WorldDef def = balloon_def();
  def.substeps = 64;
  World world(def);
  ClothDef ball = balloon(300, 150);
  ball.inflation->air_pressure = 1000;
  const ClothId id = world.create_cloth(ball);
  const float at_rest = world.cloth_state(id).volume;
  EXPECT_NEAR(world.cloth_state(id).pressure, 150, 1);
  world.set_wind({.air_density = 50});
  run(world, 60, 1 / 60.0f);
  const ClothState state = world.cloth_state(id);
  const float strain = std::cbrt(state.volume / at_rest) - 1;
  EXPECT_NEAR(strain, 0.0228f, 0.03f * 0.0228f);
  EXPECT_NEAR(state.pressure, 80.1f, 0.03f * 80.1f);
}

TEST_P(BalloonTest, ABalloonKeepsItsVolumeWhereItIsPressed) {
  ClothDef def = balloon(2000, 0);
  const ClothId id = world_.create_cloth(def);
  const float before = world_.cloth_state(id).volume;
  const BodyId top = world_.create_body(kinematic(BoxGeometry{{0.5f, 0.1f, 0.5f}}, {0, 0.36f, 0})),
               bottom = world_.create_body(kinematic(BoxGeometry{{0.5f, 0.1f, 0.5f}}, {0, -0.36f, 0}));
  world_.move_body(top, {{0, 0.25f, 0}}, 1);
  world_.move_body(bottom, {{0, -0.25f, 0}}, 1);
  run(world_, 90, 1 / 60.0f);
  const ClothState pressed = world_.cloth_state(id);
  EXPECT_NEAR(pressed.volume, before, 0.02f * before);
  EXPECT_GT(pressed.pressure, 100);
  float lowest = 0, widest = 0;
  for (Vec3 x : world_.cloth_positions(id)) {
    lowest = std::min(lowest, x.y);
    widest = std::max(widest, x.x);
  }
  EXPECT_GT(lowest, -0.151f);
  EXPECT_GT(widest, 0.28f);
}

TEST_P(BalloonTest, WithoutGasItCollapses) {
  ClothDef def = balloon(2000, 0);
  def.inflation.reset();
  const ClothId id = world_.create_cloth(def);
  const float before = world_.cloth_state(id).volume;
  const BodyId top = world_.create_body(kinematic(BoxGeometry{{0.5f, 0.1f, 0.5f}}, {0, 0.36f, 0})),
               bottom = world_.create_body(kinematic(BoxGeometry{{0.5f, 0.1f, 0.5f}}, {0, -0.36f, 0}));
  world_.move_body(top, {{0, 0.2f, 0}}, 1);
  world_.move_body(bottom, {{0, -0.2f, 0}}, 1);
  run(world_, 90, 1 / 60.0f);
  EXPECT_LT(world_.cloth_state(id).volume, 0.9f * before);
  EXPECT_EQ(world_.cloth_state(id).pressure, 0);
}

// Gas pushes from inside, and on nothing else.
TEST_P(BalloonTest, GasGivesABalloonNoMomentum) {
  ClothDef def = balloon(500, 1000);
  def.self_collision = false;
  def.stretch = {1.2f, 0.9f, 0.8f};
  def.pose.position = {5, 3, -4};
  const ClothId id = world_.create_cloth(def);
  world_.set_wind({.air_density = 0});
  double most = 0;
  for (int k = 0; k < 60; ++k) {
    world_.step(1 / 60.0f);
    const ClothState state = world_.cloth_state(id);
    double gross = 0;
    for (Vec3 v : world_.cloth_velocities(id)) gross += double{length(v)};
    gross *= double{state.mass} / static_cast<double>(world_.cloth_velocities(id).size());
    most = std::max(most, gross);
    EXPECT_LT(length(state.momentum), 1e-6 * most) << "step " << k;
  }
  EXPECT_GT(most, 0.01);
}

TEST_P(BalloonTest, ATornBalloonLosesItsGas) {
  ClothDef def = balloon(300, 60000);
  def.fabric.tear_strain = 0.1f;
  const ClothId id = world_.create_cloth(def);
  EXPECT_TRUE(world_.cloth_state(id).closed);
  run(world_, 15, 1 / 60.0f);
  const ClothState state = world_.cloth_state(id);
  EXPECT_FALSE(state.closed);
  EXPECT_EQ(state.pressure, 0);
  EXPECT_EQ(state.volume, 0);
  EXPECT_GT(world_.cloth_positions(id).size(), 362u);
  EXPECT_EQ(world_.diagnostics().non_finite, 0u);
}

TEST_P(BalloonTest, TwoBalloonsHaveEachTheirOwnGas) {
  ClothDef soft = balloon(1000, 100), hard = balloon(1000, 300);
  soft.inflation->air_pressure = hard.inflation->air_pressure = 1000;
  hard.pose.position = {2, 0, 0};
  const ClothId a = world_.create_cloth(soft);
  world_.create_cloth(sheet(0.3f, 0.3f, 4, 4, {0, 3, 0}));
  const ClothId b = world_.create_cloth(hard);
  run(world_, 60, 1 / 60.0f);
  World alone(balloon_def());
  const ClothId c = alone.create_cloth(soft);
  run(alone, 60, 1 / 60.0f);
  EXPECT_NEAR(world_.cloth_state(a).pressure, alone.cloth_state(c).pressure, 2);
  EXPECT_GT(world_.cloth_state(b).pressure, 1.5f * world_.cloth_state(a).pressure);
}

MENISCUS_ON_EACH_DEVICE(BalloonTest);

}  // namespace
}  // namespace meniscus::tests
