// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A world in a batch moves bit for bit as it does alone.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/sdk/world/batch_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float dt = batch_dt;

/// Two fluids that fall apart around a ball, in a tank with friction that is open above.
World fluids(const WorldDef& def) {
  World world(def);
  FluidDef first, second;
  first.vorticity_confinement = 0.2f;
  first.surface_tension = 0.07f;
  second.rest_density = 500;
  const FluidId a = world.create_fluid(first), b = world.create_fluid(second);
  ShapeDef walls = tank({0, 0, 0}, {1, 1, 0.5f});
  std::get<ContainerGeometry>(walls.geometry).openings = {{Face::y_high}};
  walls.surface.friction = 0.3f;
  world.create_shape(walls);
  world.create_shape(shape(SphereGeometry{0.15f}, {0.8f, 0.1f, 0.25f}));
  world.add_fluid(block(a, {0, 0, 0}, {0.5f, 0.5f, 0.5f}));
  world.add_fluid(block(b, {0, 0.5f, 0}, {0.5f, 0.7f, 0.5f}));
  return world;
}

class BatchTest : public BatchOnDevice {
 protected:
  World archetype(const WorldDef& def) const override { return fluids(def); }
};

TEST_P(BatchTest, AWorldIsAsItIsAlone) {
  expect_as_alone(1, 2, 1, 25);
  expect_as_alone(7, 0, 1, 25);
}

TEST_P(BatchTest, SoItIsAtAnyPlaceAmongMany) {
  expect_as_alone(many(), 3, 2, 25);
}

/// Their tables of cells are as small as they may be.
TEST_P(BatchTest, WorldsOfFewParticlesAreAsTheyAreAlone) {
  World drop(def());
  const FluidId water = drop.create_fluid({});
  drop.create_shape(tank({0, 0, 0}, {1, 1, 0.5f}));
  drop.add_fluid(block(water, {0.15f, 0.4f, 0.1f}, {0.45f, 0.6f, 0.4f}));
  WorldBatch made(drop, {32});
  run_batch(made, 80);
  run(drop, 80, dt);
  EXPECT_EQ(made.state_hashes()[31], drop.state_hash());
}

TEST_P(BatchTest, StartsInAnyState) {
  World world = archetype(def());
  run(world, 12, dt);
  WorldBatch made(world, {3});
  EXPECT_EQ(made.state_hashes()[2], world.state_hash());
  EXPECT_EQ(made.status()[1].time, world.time());
  run_batch(made, 10);
  const uint8_t second[] = {0, 1, 0};
  made.reset(second);
  EXPECT_EQ(made.state_hashes()[1], world.state_hash());
  run(world, 10, dt);
  EXPECT_EQ(made.state_hashes()[0], world.state_hash());
  run_batch(made, 10);
  EXPECT_EQ(made.state_hashes()[1], world.state_hash());
}

TEST_P(BatchTest, AnExtractedWorldGoesOn) {
  WorldBatch made = batch(7);
  run_batch(made, 10);
  World world = made.extract(3);
  EXPECT_EQ(world.state_hash(), made.state_hashes()[3]);
  EXPECT_EQ(world.time(), made.status()[3].time);
  EXPECT_EQ(world.positions()[5], made.positions()[3 * made.particle_count() + 5]);
  run(world, 15, dt);
  EXPECT_EQ(world.state_hash(), alone(3, 25));
}

TEST_P(BatchTest, AResetWorldIsAFreshOne) {
  WorldBatch made = batch(7);
  run_batch(made, 20);
  std::vector<uint8_t> mask(7, 0);
  mask[2] = mask[6] = 1;
  made.reset(mask);
  EXPECT_EQ(made.status()[2].time, 0);
  run_batch(made, 100);
  for (uint32_t w = 0; w < 7; ++w)
    EXPECT_EQ(made.state_hashes()[w], alone(w, mask[w] ? 100 : 120)) << "world " << w;
}

TEST_P(BatchTest, AWorldThatFailsGoesBackAlone) {
  WorldBatch made = batch(7);
  run_batch(made, 5);
  const uint64_t before = made.state_hashes()[4];
  made.set_gravity(4, {0, 1e30f, 0});
  const BatchReport report = made.step(dt);
  EXPECT_EQ(report.failed, 1u);
  EXPECT_EQ(report.stepped, 6u);
  EXPECT_TRUE(made.status()[4].failed);
  EXPECT_EQ(made.step(dt).failed, 0u) << "it waits for its reset";
  run_batch(made, 13);
  for (uint32_t w = 0; w < 7; ++w)
    EXPECT_EQ(made.state_hashes()[w], w == 4 ? before : alone(w, 20)) << "world " << w;
  made.set_gravity(4, gravity_of(4));
  std::vector<uint8_t> mask(7, 0);
  mask[4] = 1;
  made.reset(mask);
  run_batch(made, 10);
  EXPECT_EQ(made.state_hashes()[4], alone(4, 10));
  EXPECT_EQ(made.state_hashes()[5], alone(5, 30));
}

TEST_P(BatchTest, APausedWorldStays) {
  WorldBatch made = batch(5);
  run_batch(made, 5);
  const std::vector<uint8_t> mask{1, 0, 1, 1, 0};
  made.set_active(mask);
  EXPECT_EQ(made.step(dt).stepped, 3u);
  run_batch(made, 4);
  made.set_active(std::vector<uint8_t>(5, 1));
  run_batch(made, 10);
  for (uint32_t w = 0; w < 5; ++w)
    EXPECT_EQ(made.state_hashes()[w], alone(w, mask[w] ? 20 : 15)) << "world " << w;
  made.set_active(std::vector<uint8_t>(5, 0));
  EXPECT_EQ(made.step(dt).stepped, 0u);
}

TEST_P(BatchTest, AWarmStepAllocatesNothing) {
  WorldBatch made = batch(7);
  std::vector<uint8_t> mask(7, 0);
  mask[1] = 1;
  run_batch(made, 60);
  made.reset(mask);
  run_batch(made, 5);
  const size_t before = made.memory_stats().device.allocations;
  made.reset(mask);
  run_batch(made, 5);
  EXPECT_EQ(made.memory_stats().device.allocations, before);
}

TEST_P(BatchTest, ArraysAreThoseOfTheReadOuts) {
  WorldBatch made = batch(3);
  run_batch(made, 5);
  const BatchArrays arrays = made.device_arrays();
  const auto each = static_cast<int64_t>(made.particle_count());
  EXPECT_EQ(arrays.velocities.dimensions, 3);
  EXPECT_EQ(arrays.positions.shape, (std::array<int64_t, 3>{3, each, 3}));
  EXPECT_EQ(arrays.positions.strides, (std::array<int64_t, 3>{3 * each, 3, 1}));
  EXPECT_EQ(made.positions().size(), 3u * made.particle_count());
  if (arrays.positions.on_cuda) return;
  const auto* const positions = static_cast<const Vec3*>(arrays.positions.data);
  const auto* const velocities = static_cast<const Vec3*>(arrays.velocities.data);
  EXPECT_TRUE(std::equal(made.positions().begin(), made.positions().end(), positions));
  EXPECT_TRUE(std::equal(made.velocities().begin(), made.velocities().end(), velocities));
}

// ---- refusals ----

std::string refusal(const World& world, const BatchDef& batch = {2}) {
  return refusal_of([&] { WorldBatch(world, batch); });
}

TEST_P(BatchTest, NamesWhatItDoesNotTake) {
  const auto expect_refused = [&](const char* what, const auto& change) {
    World world = archetype(def());
    change(world);
    EXPECT_NE(refusal(world).find(what), std::string::npos) << refusal(world);
  };
  expect_refused("ropes", [](World& w) {
    RopeDef rope;
    rope.points = {{0.7f, 0.5f, 0.2f}, {0.7f, 0.8f, 0.2f}};
    w.create_rope(rope);
  });
  expect_refused("emitters", [](World& w) {
    EmitterDef emitter;
    emitter.fluid = w.fluid_ids().front();
    w.create_emitter(emitter);
  });
  expect_refused("sinks", [](World& w) { w.create_sink({}); });
  expect_refused("probes", [](World& w) { w.create_probe({}); });
  expect_refused("force fields", [](World& w) { w.create_force_field({}); });
  expect_refused("hooks", [](World& w) { w.add_hook(Hook::solved, [](const SubstepView&) {}); });
  expect_refused("granular", [](World& w) { w.create_granular({}); });
  expect_refused("dynamic_viscosity", [](World& w) {
    FluidDef thick;
    thick.dynamic_viscosity = 1;
    w.create_fluid(thick);
  });
  const auto expect_def_refused = [&](const char* what, const auto& change) {
    WorldDef other = def();
    change(other);
    EXPECT_NE(refusal(archetype(other)).find(what), std::string::npos) << refusal(archetype(other));
  };
  expect_def_refused("sums", [](WorldDef& d) { d.sums = Sums::automatic; });
  expect_def_refused("diffuse", [](WorldDef& d) { d.diffuse.emplace(); });
  expect_def_refused("step_budget_ms", [](WorldDef& d) { d.step_budget_ms = 5; });
  expect_def_refused("cfl_number", [](WorldDef& d) { d.cfl_number = 0.4f; });
  expect_def_refused("density.tolerance", [](WorldDef& d) { d.density.tolerance = 0.01f; });
  expect_def_refused("density.solver", [](WorldDef& d) { d.density.solver = DensitySolver::grid; });
  EXPECT_NE(refusal(World(def())).find("no particles"), std::string::npos);
  EXPECT_NE(refusal(archetype(def()), {0}).find("BatchDef::worlds"), std::string::npos);
}

TEST_P(BatchTest, ChecksItsArguments) {
  WorldBatch made = batch(3);
  made.step(dt);
  EXPECT_THROW(made.step(2 * dt), Error) << "pressures belong to one length of a step";
  EXPECT_THROW(made.step(0), Error);
  EXPECT_THROW(made.reset(std::vector<uint8_t>(2, 1)), Error);
  EXPECT_THROW(made.set_active(std::vector<uint8_t>(4, 1)), Error);
  EXPECT_THROW(made.set_gravity(3, {0, -1, 0}), Error);
  EXPECT_THROW(made.extract(3), Error);
  EXPECT_EQ(made.state_hashes()[0], alone(0, 1));
}

MENISCUS_ON_EACH_DEVICE(BatchTest);

}  // namespace
}  // namespace meniscus::tests
