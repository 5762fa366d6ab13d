// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Emitters with little free space: no particle is created inside another or a solid, and none gets a high
// speed.
#include <gtest/gtest.h>

#include "tests/unit/sdk/world/flow/emitter_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float s = emitter_spacing;

class EmitterRoomTest : public OnDevice {
 protected:
  static EmitterDef jet(FluidId fluid, Vec3 position, float speed) {
    EmitterDef def = emitter(fluid, RectangleOpening{4 * s, 4 * s}, speed);
    def.pose.position = position;
    return def;
  }
};

TEST_P(EmitterRoomTest, WhereAParticleIsThereIsNoRoom) {
  World world(weightless(GetParam(), s));
  const FluidId water = world.create_fluid({});
  const std::vector<Vec3> taken{{0.5f * s, s, 0.5f * s}};
  world.add_particles(water, taken);
  EmitterDef def = emitter(water, RectangleOpening{2 * s, 2 * s}, 1);
  world.create_emitter(def);
  world.step(1.5f * s);  // one layer, a spacing in front
  EXPECT_EQ(world.particle_count(), 4u);
  EXPECT_GE(nearest_pair(world), 0.7f);
}

TEST_P(EmitterRoomTest, NothingIsMadeInsideASolidOrBeyondOne) {
  for (float thickness : {0.001f, 0.3f}) {
    World world(weightless(GetParam(), s));
    const FluidId water = world.create_fluid({});
    world.create_shape(shape(BoxGeometry{{1, thickness, 1}}, {0, 0.3f + thickness, 0}));
    // A step is long enough to be beyond the plate in one.
    world.create_emitter(jet(water, {0, 0, 0}, 20));
    run(world, 10, 0.05f);
    EXPECT_GT(world.particle_count(), 20u);
    for (Vec3 p : world.positions())
      EXPECT_TRUE(p.y < 0.3f || std::fabs(p.x) > 0.9f || std::fabs(p.z) > 0.9f);
    EXPECT_EQ(world.diagnostics().outside, 0u);
  }
}

TEST_P(EmitterRoomTest, AnOpeningFlushWithAWallIsNotBlockedByIt) {
  World world(weightless(GetParam(), s));
  const FluidId water = world.create_fluid({});
  world.create_shape(shape(PlaneGeometry{}));
  const EmitterId id = world.create_emitter(jet(water, {0, 0, 0}, 1));
  run(world, 60, 1.0f / 60);
  EXPECT_NEAR(double(world.emitter_count(id).total), 16 * 20, 16);
}

TEST_P(EmitterRoomTest, SolidsThatAFluidPassesThroughAreNotInItsWay) {
  World world(weightless(GetParam(), s));
  FluidDef ghost;
  ghost.filter = {2, 2};
  world.create_shape(shape(BoxGeometry{{1, 1, 1}}));
  const EmitterId id = world.create_emitter(jet(world.create_fluid(ghost), {0, 0, 0}, 1));
  run(world, 30, 1.0f / 60);
  EXPECT_GT(world.emitter_count(id).total, 140u);
}

TEST_P(EmitterRoomTest, AClosedVesselFillsAndThenNothingComes) {
  World world(world_def(GetParam(), s));
  const FluidId water = world.create_fluid({});
  world.create_shape(tank({0, 0, 0}, {6 * s, 6 * s, 6 * s}));
  EmitterDef def = jet(water, {3 * s, 6 * s, 3 * s}, 1);
  def.pose.rotation = about_z(180);
  const EmitterId id = world.create_emitter(def);
  float fastest = 0;
  for (int k = 0; k < 120; ++k) fastest = std::max(fastest, world.step(1.0f / 60).max_speed);
  EXPECT_NEAR(static_cast<double>(world.particle_count()), 216, 25);
  EXPECT_EQ(world.diagnostics().outside, 0u);
  EXPECT_LT(fastest, 8);
  EXPECT_LE(world.emitter_count(id).last_step, 1u);
}

TEST_P(EmitterRoomTest, WhatAFullVesselRefusesIsReported) {
  World world(world_def(GetParam(), s));
  const FluidId water = world.create_fluid({});
  world.create_shape(tank({0, 0, 0}, {6 * s, 6 * s, 6 * s}));
  EmitterDef def = jet(water, {3 * s, 6 * s, 3 * s}, 1);
  def.pose.rotation = about_z(180);
  const EmitterId id = world.create_emitter(def);
  constexpr double asked = 16.0 * s * s / 60;  // m³ a step
  double refused = 0;
  for (int k = 0; k < 120; ++k) {
    const double now = world.step(1.0f / 60).emission_refused;
    EXPECT_GE(now, 0);
    EXPECT_LE(now, 1.3 * asked);
    refused += now;
  }
  constexpr double layer = 16.0 * s * s * s;  // the first one leaves within the first period
  EXPECT_NEAR(emitted_volume(world, id) + refused, 120 * asked - 0.5 * layer, 0.7 * layer);
  EXPECT_NEAR(world.step(1.0f / 60).emission_refused, asked, 0.3 * asked);
}

TEST_P(EmitterRoomTest, TwoEmittersInOnePlaceDoNotOverlap) {
  World world(weightless(GetParam(), s));
  const FluidId water = world.create_fluid({});
  world.create_emitter(jet(water, {0, 0, 0}, 1));
  world.create_emitter(jet(water, {0.3f * s, 0, 0.2f * s}, 1));
  for (int k = 0; k < 20; ++k) {
    world.step(0.01f);
    EXPECT_GT(nearest_pair(world), 0.6f);
  }
  EXPECT_GT(world.particle_count(), 16u);
}

TEST_P(EmitterRoomTest, InAPoolItDoesNotExplode) {
  World world(world_def(GetParam(), s));
  const FluidId water = world.create_fluid({});
  world.create_shape(open_tank({0.3f, 1, 0.3f}));
  world.add_fluid(block(water, {-0.3f, 0, -0.3f}, {0.3f, 0.4f, 0.3f}));
  run(world, 20, 1.0f / 60);
  const size_t before = world.particle_count();
  world.create_emitter(jet(water, {0, 0, 0}, 1));
  float fastest = 0;
  for (int k = 0; k < 60; ++k) fastest = std::max(fastest, world.step(1.0f / 60).max_speed);
  EXPECT_GT(world.particle_count(), before + 60);  // of 320 that it would make in air
  EXPECT_LT(fastest, 5);
  EXPECT_LT(world.diagnostics().density_error_mean, 0.03);
  EXPECT_EQ(world.diagnostics().outside, 0u);
}

TEST_P(EmitterRoomTest, ItWorksBesideBodiesAndCloth) {
  World world(world_def(GetParam(), s));
  const FluidId water = world.create_fluid({});
  world.create_shape(shape(PlaneGeometry{}));
  world.create_body(body(BoxGeometry{{0.1f, 0.1f, 0.1f}}, {0.2f, 0.1f, 0}));
  ClothDef cloth;
  cloth.geometry = SheetGeometry{0.2f, 0.2f, 5, 5};
  cloth.pose.position = {5, 0.4f, 0};
  const ClothId sheet = world.create_cloth(cloth);
  EmitterDef def = jet(water, {-0.2f, 1, 0}, 1);
  def.pose.rotation = about_z(180);
  world.create_emitter(def);
  run(world, 40, 1.0f / 60);
  EXPECT_GT(world.particle_count(), 100u);
  for (Vec3 p : world.cloth_positions(sheet)) EXPECT_GT(p.y, 0);
  EXPECT_EQ(world.diagnostics().non_finite, 0u);
  for (const ParticleContact& c : world.particle_contacts())
    EXPECT_TRUE(std::binary_search(world.ids().begin(), world.ids().end(), c.particle));
}

MENISCUS_ON_EACH_DEVICE(EmitterRoomTest);

}  // namespace
}  // namespace meniscus::tests
