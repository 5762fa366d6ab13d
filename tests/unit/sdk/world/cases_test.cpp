// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Unusual worlds at the limits of what is supported.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

class CasesTest : public OnDevice {};

TEST_P(CasesTest, AnEmptyWorldSteps) {
  World world(world_def(GetParam(), 0.05f));
  run(world, 3, 0.01f);
  EXPECT_NEAR(world.time(), 0.03, 1e-6);
  world.create_shape(tank({0, 0, 0}, {1, 1, 1}));
  world.create_fluid({});
  const StepReport report = world.step(0.01f);
  EXPECT_EQ(report.contacts, 0u);
  EXPECT_EQ(report.max_speed, 0);
  world.relax();
  const Diagnostics d = world.diagnostics();
  EXPECT_EQ(d.particles, 0u);
  EXPECT_EQ(d.density_error_mean, 0);
  EXPECT_TRUE(world.positions().empty());
  EXPECT_TRUE(world.density_errors().empty());
}

TEST_P(CasesTest, OneParticleFallsAndComesToRest) {
  World world(world_def(GetParam(), 0.05f));
  world.create_shape(tank({0, 0, 0}, {1, 1, 1}));
  world.add_particles(world.create_fluid({}), std::vector<Vec3>{{0.5f, 0.5f, 0.5f}});
  run(world, 20, 0.01f);
  EXPECT_NEAR(world.velocities()[0].y, -9.81f * 0.2f, 1e-3f);
  run(world, 100, 0.01f);
  EXPECT_NEAR(world.positions()[0].y, 0.025f, 0.0005f);
  EXPECT_LT(length(world.velocities()[0]), 1e-3f);
}

TEST_P(CasesTest, TwoParticlesInOnePlaceStayFinite) {
  World world(world_def(GetParam(), 0.05f));
  world.create_shape(tank({0, 0, 0}, {1, 1, 1}));
  world.add_particles(world.create_fluid({}), std::vector<Vec3>(50, Vec3{0.5f, 0.5f, 0.5f}));
  run(world, 50, 0.01f);
  EXPECT_EQ(world.diagnostics().non_finite, 0u);
  EXPECT_EQ(world.diagnostics().outside, 0u);
}

TEST_P(CasesTest, WithoutGravityNothingStartsToMove) {
  WorldDef def = world_def(GetParam(), 0.1f);
  def.gravity = {0, 0, 0};
  World world = dam_break(def);
  run(world, 50, 0.016f);
  EXPECT_LT(world.diagnostics().max_speed, 0.01f);
}

TEST_P(CasesTest, GravityMayPointAnywhere) {
  WorldDef def = world_def(GetParam(), 0.1f);
  def.gravity = {0, 0, 9.81f};
  World world(def);
  world.create_shape(tank({0, 0, 0}, {0.5f, 0.5f, 2}));
  world.add_fluid(block(world.create_fluid({}), {0, 0, 0}, {0.5f, 0.5f, 1}));
  run(world, 150, 0.016f);
  double z = 0;
  for (Vec3 p : world.positions()) z += p.z;
  EXPECT_NEAR(z / static_cast<double>(world.particle_count()), 1.5, 0.05);
  EXPECT_EQ(world.diagnostics().outside, 0u);
}

// At 1000 m a float's step is 0.06 mm.
TEST_P(CasesTest, AKilometreFromTheOriginTheDamBreaksTheSame) {
  double height[2];
  for (int far : {0, 1}) {
    const float x = far ? 1000.0f : 0.0f;
    World world(world_def(GetParam(), 0.1f));
    world.create_shape(tank({x, 0, 0}, {x + 1, 1, 0.5f}));
    world.add_fluid(block(world.create_fluid({}), {x, 0, 0}, {x + 0.5f, 0.8f, 0.5f}));
    EXPECT_EQ(world.particle_count(), 200u);
    run(world, 250, 0.016f);
    height[far] = mean_height(world);
    EXPECT_EQ(world.diagnostics().outside, 0u);
    EXPECT_LT(world.diagnostics().max_speed, 2);
  }
  EXPECT_NEAR(height[1] / height[0], 1, 0.05);
}

TEST_P(CasesTest, TheHeavyFluidSinksBelowTheLight) {
  World world(world_def(GetParam(), 0.0625f));
  FluidDef light, heavy;
  light.rest_density = 400;
  const FluidId oil = world.create_fluid(light), water = world.create_fluid(heavy);
  world.create_shape(tank({0, 0, 0}, {0.5f, 0.8f, 0.25f}));
  world.add_fluid(block(water, {0, 0.25f, 0}, {0.5f, 0.5f, 0.25f}));
  world.add_fluid(block(oil, {0, 0, 0}, {0.5f, 0.25f, 0.25f}));
  run(world, 375, 0.016f);
  double height[2] = {}, count[2] = {};
  for (size_t i = 0; i < world.particle_count(); ++i) {
    height[world.fluids()[i]] += world.positions()[i].y;
    count[world.fluids()[i]] += 1;
  }
  EXPECT_EQ(count[oil.index], count[water.index]);
  // Layers quite apart would be .25 m apart in the mean; what is left of the turmoil mixes them.
  EXPECT_GT(height[oil.index] / count[oil.index], height[water.index] / count[water.index] + 0.12);
}

TEST_P(CasesTest, AdaptiveSubstepsFollowTheSpeedWithinTheirLimits) {
  WorldDef def = world_def(GetParam(), 0.05f);
  def.gravity = {0, 0, 0};
  def.cfl_number = 0.5f;
  def.min_substeps = 2;
  def.max_substeps = 12;
  for (const auto& [speed, expected] :
       {std::pair{0.0f, 2}, {10.0f, 2}, {20.0f, 4}, {40.0f, 8}, {500.0f, 12}}) {
    World world(def);
    const std::vector<Vec3> position{{0, 0, 0}}, velocity{{speed, 0, 0}};
    world.add_particles(world.create_fluid({}), position, velocity);
    const StepReport report = world.step(0.0099f);  // h is 0.1 m: one substep a 5 m/s
    EXPECT_EQ(report.substeps, expected) << speed << " m/s";
    EXPECT_NEAR(world.positions()[0].x, speed * 0.0099f, 1e-4f * speed);
  }
}

TEST_P(CasesTest, RelaxTakesTheEnergyOutOfAnOverlap) {
  float speed[2];
  for (bool relaxed : {false, true}) {
    WorldDef def = world_def(GetParam(), 0.05f);
    def.gravity = {0, 0, 0};
    World world(def);
    const FluidId water = world.create_fluid({});
    world.add_particles(water, lattice(8, 8, 8, 0.05f, {0, 0, 0}));
    world.add_particles(water, lattice(8, 8, 8, 0.05f, {0.33f, 0.02f, 0.01f}));
    if (relaxed) world.relax();
    world.step(0.016f);
    speed[relaxed] = world.diagnostics().max_speed;
  }
  EXPECT_GT(speed[0], 1);
  EXPECT_LT(speed[1], 0.1f);
}

TEST_P(CasesTest, RelaxStopsTheParticlesAndKeepsTime) {
  World world = dam_break(GetParam());
  run(world, 10, 0.016f);
  const double time = world.time();
  world.relax(5);
  EXPECT_EQ(world.time(), time);
  EXPECT_EQ(world.diagnostics().max_speed, 0);
  EXPECT_EQ(world.diagnostics().outside, 0u);
}

TEST_P(CasesTest, AStepReportsWhatItDid) {
  WorldDef def = world_def(GetParam(), 0.05f);
  def.substeps = 3;
  def.iterations = 7;
  World world = dam_break(def);
  const StepReport report = world.step(0.01f);
  EXPECT_EQ(report.substeps, 3);
  EXPECT_EQ(report.iterations, 7);
  EXPECT_EQ(report.density_iterations, 7);
  EXPECT_GT(report.contacts, 400u);
  EXPECT_EQ(report.removed, 0u);
  EXPECT_GT(report.ms, 0);
  const auto is_empty = [](Stage stage) {  // a GPU's contacts count with its neighbours
    return stage == Stage::exchange || (stage == Stage::contacts && GetParam() == pbd::DeviceKind::cuda);
  };
  for (size_t k = 0; k < stage_count; ++k) {
    if (!is_empty(Stage(k))) {
      EXPECT_GT(report.stage_ms[k], 0) << stage_name(Stage(k));
    }
  }
  EXPECT_EQ(report.stage_ms[static_cast<size_t>(Stage::exchange)], 0);  // without bodies there is none
  EXPECT_GT(report.max_neighbours, 20u);
  EXPECT_LT(report.max_neighbours, 64u);
  EXPECT_NEAR(report.max_speed, world.diagnostics().max_speed, 1e-6);
}

TEST_P(CasesTest, DiagnosticsCountAContactForEachWall) {
  World world(world_def(GetParam(), 0.05f));
  world.create_shape(tank({0, 0, 0}, {1, 1, 1}));
  world.add_particles(world.create_fluid({}), std::vector<Vec3>{{0.03f, 0.03f, 0.03f}, {0.5f, 0.5f, 0.5f}});
  world.step(0.001f);
  EXPECT_EQ(world.diagnostics().contacts, 3u);
}

TEST_P(CasesTest, AMovedWorldIsTheSameWorld) {
  World world = dam_break(GetParam(), 0.1f);
  const uint64_t hash = world.state_hash();
  World moved = std::move(world);
  EXPECT_EQ(moved.state_hash(), hash);
  run(moved, 2, 0.016f);
  world = std::move(moved);
  EXPECT_NEAR(world.time(), 0.032, 1e-6);
}

TEST_P(CasesTest, SmallAndLargeWorldsRunAlike) {
  double relative[3];
  for (int k = 0; k < 3; ++k) {
    const float scale = k == 0 ? 1.0f : k == 1 ? 0.01f : 100.0f;
    World world(world_def(GetParam(), 0.1f * scale));
    world.create_shape(tank({0, 0, 0}, scale * Vec3{1, 1, 0.5f}));
    world.add_fluid(block(world.create_fluid({}), {0, 0, 0}, scale * Vec3{0.5f, 0.8f, 0.5f}));
    EXPECT_EQ(world.particle_count(), 200u);
    run(world, 100, 0.016f * std::sqrt(scale));
    relative[k] = mean_height(world) / scale;
    EXPECT_EQ(world.diagnostics().outside, 0u);
  }
  EXPECT_NEAR(relative[1] / relative[0], 1, 0.05);
  EXPECT_NEAR(relative[2] / relative[0], 1, 0.05);
}

MENISCUS_ON_EACH_DEVICE(CasesTest);

}  // namespace
}  // namespace meniscus::tests
