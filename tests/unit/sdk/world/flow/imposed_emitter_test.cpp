// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Imposed emitters: their volume and pressure under water, full vessels, what ends them, and what they
// refuse.
#include <gtest/gtest.h>

#include "tests/unit/sdk/world/flow/emitter_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float s = emitter_spacing;
constexpr float dt = 1.0f / 60;

class ImposedEmitterTest : public OnDevice {
 protected:
  static EmitterDef piston(FluidId fluid, float speed) {
    EmitterDef def = emitter(fluid, RectangleOpening{4 * s, 4 * s}, speed);
    def.mode = EmitterMode::imposed;
    return def;
  }
  /// Water of this depth in a tank, 8 × 8 spacings wide.
  static FluidId fill_tank(World& world, float depth) {
    const FluidId water = world.create_fluid({});
    world.create_shape(open_tank({4 * s, depth, 4 * s}));
    world.add_fluid(block(water, {-4 * s, 0, -4 * s}, {4 * s, depth, 4 * s}));
    return water;
  }
  /// A full vessel of 8 spacings cubed.
  static void refuses_when_full(float speed) {
    World world(world_def(GetParam(), s));
    const FluidId water = world.create_fluid({});
    world.create_shape(tank({0, 0, 0}, {8 * s, 8 * s, 8 * s}));
    world.add_fluid(block(water, {0, 0, 0}, {8 * s, 8 * s, 8 * s}));
    EmitterDef def = piston(water, speed);
    def.pose.position = {4 * s, 0, 4 * s};
    const EmitterId id = world.create_emitter(def);
    world.step(dt);
    const double volume = double{s} * s * s, layer = 16 * volume, asked = 16.0 * double{s} * s * double{dt};
    double refused = 0;
    constexpr int steps = 60;
    for (int k = 0; k < steps; ++k) refused += world.step(dt).emission_refused;
    EXPECT_NEAR(emitted_volume(world, id) + refused, steps * double{speed} * asked, layer);
    EXPECT_LT(emitted_volume(world, id), 0.1 * 512 * volume);
    const StepReport report = world.step(dt);
    EXPECT_NEAR(report.emission_refused / (double{speed} * asked), 1, 1e-6);
    EXPECT_LT(report.max_speed, 12);
    const Diagnostics now = world.diagnostics();
    EXPECT_EQ(now.non_finite, 0u);
    EXPECT_EQ(now.outside, 0u);
    EXPECT_LT(now.density_error_interior, 0.06);
  }
};

TEST_P(ImposedEmitterTest, UnderWaterItDeliversAtThePressureThere) {
  World world(world_def(GetParam(), s));
  const FluidId water = fill_tank(world, 1);
  run(world, 30, dt);
  const EmitterId id = world.create_emitter(piston(water, 1));
  world.step(dt);  // it begins at the end of this step
  const size_t before = world.particle_count();
  constexpr int steps = 90, start = 30;  // 30 layers
  double refused = 0, pressure = 0, expected = 0, error = 0;
  for (int k = 0; k < steps; ++k) {
    refused += world.step(dt).emission_refused;
    if (k < start) continue;
    pressure += world.emitter_pressure(id);
    const double depth = 1 + emitted_volume(world, id) / double{8 * s * 8 * s};
    expected += 1000 * 9.81 * depth;  // a jet under water leaves at the pressure around it
    if (k % 10 == 0) error = std::max(error, world.diagnostics().density_error_mean);
  }
  const double asked = 16.0 * double{s} * s * steps * double{dt};
  EXPECT_NEAR(emitted_volume(world, id), asked, 0.01 * asked);
  EXPECT_EQ(refused, 0);
  EXPECT_NEAR(pressure / expected, 1, 0.1);
  EXPECT_LT(error, 0.02);
  const Diagnostics now = world.diagnostics();
  EXPECT_LT(now.density_error_interior, 0.02);
  EXPECT_EQ(now.outside, 0u);
  EXPECT_EQ(world.particle_count() - before, world.emitter_count(id).total);
}

TEST_P(ImposedEmitterTest, AFullVesselRefusesAndStaysAsItIs) {
  for (const float speed : {1.0f, 20.0f}) refuses_when_full(speed);
}

TEST_P(ImposedEmitterTest, InAirItMakesAJetAndEndsInWholeLayers) {
  World world(weightless(GetParam(), s));
  EmitterDef def = piston(world.create_fluid({}), 1);
  def.stop = 0.5f;
  const EmitterId id = world.create_emitter(def);
  run(world, 20, dt);
  EXPECT_EQ(world.particle_count(), world.emitter_count(id).total + 48);  // three layers in the duct
  run(world, 12, dt);
  EXPECT_EQ(world.emitter_count(id).total, 16u * 10);  // 9.67 layers
  EXPECT_EQ(world.particle_count(), 160u);
  run(world, 5, dt);
  EXPECT_EQ(world.particle_count(), 160u);
  for (const Vec3 v : world.velocities()) EXPECT_NEAR(v.y, 1, 0.05);
}

TEST_P(ImposedEmitterTest, MostParticlesAndDestructionEndIt) {
  World world(weightless(GetParam(), s));
  EmitterDef def = piston(world.create_fluid({}), 1);
  def.most_particles = 40;
  const EmitterId limited = world.create_emitter(def);
  run(world, 20, dt);
  EXPECT_EQ(world.emitter_count(limited).total, 32u);
  EXPECT_EQ(world.particle_count(), 32u);
  def.most_particles = {};
  def.pose.position = {3, 0, 0};
  const EmitterId destroyed = world.create_emitter(def);
  run(world, 7, dt);  // two layers
  const uint64_t left = world.emitter_count(destroyed).total;
  EXPECT_EQ(left, 32u);
  EXPECT_GT(world.particle_count(), 64u);
  world.destroy_emitter(destroyed);
  EXPECT_EQ(world.particle_count(), 64u);
  run(world, 3, dt);
  EXPECT_EQ(world.particle_count(), 64u);
}

TEST_P(ImposedEmitterTest, WithWaterBehindItNothingIsMade) {
  World world(world_def(GetParam(), s));
  const FluidId water = fill_tank(world, 0.6f);
  EmitterDef def = piston(water, 1);
  def.pose.position = {0, 0.3f, 0};
  const EmitterId id = world.create_emitter(def);
  const size_t before = world.particle_count();
  world.step(dt);
  double refused = 0;
  for (int k = 0; k < 10; ++k) refused += world.step(dt).emission_refused;
  EXPECT_NEAR(refused, 10 * 16.0 * double{s} * s * double{dt}, 1e-6);
  EXPECT_EQ(world.particle_count(), before);
  EXPECT_EQ(world.emitter_pressure(id), 0);
}

TEST_P(ImposedEmitterTest, SinksLeaveTheDuct) {
  World world(world_def(GetParam(), s));
  const FluidId water = fill_tank(world, 0.4f);
  SinkDef around;
  around.region = BoxRegion{{-1, -0.02f, -1}, {1, 2, 1}};
  around.outside = true;
  world.create_sink(around);
  const EmitterId id = world.create_emitter(piston(water, 1));
  double refused = 0;
  for (int k = 0; k < 30; ++k) refused += world.step(dt).emission_refused;
  EXPECT_EQ(world.emitter_count(id).total, 16u * 9);
  EXPECT_EQ(refused, 0);
}

TEST_P(ImposedEmitterTest, GoesOnBitForBitFromASnapshot) {
  World world(world_def(GetParam(), s));
  const FluidId water = fill_tank(world, 0.4f);
  const EmitterId id = world.create_emitter(piston(water, 1));
  run(world, 11, dt);
  const Snapshot then = world.snapshot();
  const TemporaryFolder folder;
  const std::string file = folder.write("state", "");
  world.save(file);
  const auto future = [&](World& w) {
    std::vector<double> values;
    for (int k = 0; k < 5; ++k) {
      values.push_back(w.step(dt).emission_refused);
      values.push_back(w.emitter_pressure(w.emitter_ids().front()));
      values.push_back(static_cast<double>(w.state_hash() >> 12));
    }
    return values;
  };
  const std::vector<double> expected = future(world);
  world.destroy_emitter(id);
  run(world, 2, dt);
  world.restore(then);
  EXPECT_EQ(future(world), expected);
  World loaded = World::load(file, {world.def().device});
  EXPECT_EQ(future(loaded), expected);
}

TEST_P(ImposedEmitterTest, NamesWhatItCannotBe) {
  World world(world_def(GetParam(), s));
  const FluidId water = world.create_fluid({});
  const auto refuses = [&](const char* what, EmitterDef def) {
    def.mode = EmitterMode::imposed;
    expect_error(ErrorCode::invalid_argument, what, [&] { world.create_emitter(def); });
  };
  const TemporaryFolder folder;
  refuses("EmitterDef::mode", emitter(water, MeshOpening{folder.write("brick.obj", brick_obj), 0.1f}, 1));
  EmitterDef carried = emitter(water, DiscOpening{}, 1);
  carried.body = world.create_body(body(BoxGeometry{}));
  refuses("EmitterDef::mode", carried);
  refuses("EmitterDef::mode", emitter(world.create_granular({}), DiscOpening{}, 1));
  world.create_emitter(piston(water, 1));
  WorldDef def = world.def();
  def.density.solver = DensitySolver::grid;
  expect_error(ErrorCode::invalid_argument, "DensitySolverDef::solver", [&] { world.set_def(def); });
  World gridded(def);
  const FluidId its = gridded.create_fluid({});
  expect_error(ErrorCode::invalid_argument, "DensitySolverDef::solver",
               [&] { gridded.create_emitter(piston(its, 1)); });
}

MENISCUS_ON_EACH_DEVICE(ImposedEmitterTest);

}  // namespace
}  // namespace meniscus::tests
