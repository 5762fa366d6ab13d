// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A world that is restored goes on bit for bit as it did, whatever happened in between.
#include <set>

#include "tests/expect_error.h"
#include "tests/unit/sdk/world/snapshot/cases.h"

namespace meniscus::tests {
namespace {

constexpr int steps = 4;

class SnapshotTest : public OnDevice {};

TEST_P(SnapshotTest, TheFutureIsTheSame) {
  for (const SnapshotCase& c : snapshot_cases()) {
    SCOPED_TRACE(c.name);
    World world = c.make(world_def(GetParam(), 0.05f));
    run(world, c.before, snapshot_step);
    const auto then = state_of(world);
    const Snapshot snapshot = world.snapshot();
    EXPECT_EQ(state_of(world), then) << "a snapshot leaves a trace";
    const auto future = future_of(world, steps);
    EXPECT_NE(future.front(), then);
    for (int k = 0; k < 2; ++k) {
      world.step(0.3f * snapshot_step);  // another length, which multipliers note
      world.restore(snapshot);
      EXPECT_EQ(state_of(world), then);
      EXPECT_EQ(future_of(world, steps), future);
    }
  }
}

/// Otherwise the tests of these worlds show little.
TEST_P(SnapshotTest, TheCasesAreInTheMidstOfThings) {
  std::set<std::string> seen;
  for (const SnapshotCase& c : snapshot_cases()) {
    World world = c.make(world_def(GetParam(), 0.05f));
    size_t cloth_vertices = 0;
    for (const ClothId id : world.cloth_ids()) cloth_vertices += world.cloth_positions(id).size();
    run(world, c.before, snapshot_step);
    for (const ClothId id : world.cloth_ids()) {
      cloth_vertices -= world.cloth_positions(id).size();
      for (const float wetness : world.cloth_wetness(id))
        if (wetness > 0) seen.insert("wet");
    }
    if (cloth_vertices != 0) seen.insert("torn");
    for (const BodyId id : world.body_ids()) seen.insert(world.body_state(id).awake ? "awake" : "asleep");
    for (const EmitterId id : world.emitter_ids())
      if (world.emitter_count(id).last_step > 0) seen.insert("emits");
    for (const SinkId id : world.sink_ids())
      if (world.sink_count(id).total > 0) seen.insert("drained");
    if (!world.diffuse().empty()) seen.insert("spray");
    if (!world.solid_contacts().empty()) seen.insert("solids touch");
  }
  EXPECT_EQ(seen, (std::set<std::string>{"asleep", "awake", "drained", "emits", "solids touch", "spray",
                                         "torn", "wet"}));
}

TEST_P(SnapshotTest, RestoresWhatCallsHaveChanged) {
  World world = dam_break(GetParam());
  run(world, 5, snapshot_step);
  const Snapshot snapshot = world.snapshot();
  const auto future = future_of(world, steps);
  world.restore(snapshot);
  WorldDef def = world.def();
  def.gravity = {3, 0, 0};
  def.iterations = 2;
  world.set_def(def);
  const FluidId sand = world.create_granular({});
  world.add_fluid(block(sand, {0.7f, 0, 0}, {0.9f, 0.3f, 0.4f}));
  const ClothId cloth = world.create_cloth(sheet(0.3f, 0.3f, 7, 7, {0.7f, 0.8f, 0.25f}));
  run(world, 3, snapshot_step);
  world.restore(snapshot);
  EXPECT_EQ(future_of(world, steps), future);
  EXPECT_TRUE(world.cloth_ids().empty());
  expect_error(ErrorCode::not_found, "no cloth", [&] { world.cloth_positions(cloth); });
  expect_error(ErrorCode::not_found, "no fluid", [&] { world.particle_mass(sand); });
}

TEST_P(SnapshotTest, BringsBackClothThatWasDestroyed) {
  World world(world_def(GetParam(), 0.1f));
  const ClothId cloth = world.create_cloth(sheet(0.3f, 0.3f, 7, 7, {0, 1, 0}));
  world.create_attachment(attach(cloth, {0, 6}));
  run(world, 5, snapshot_step);
  const Snapshot snapshot = world.snapshot();
  const auto future = future_of(world, steps);
  world.destroy_cloth(cloth);
  world.step(snapshot_step);
  world.restore(snapshot);
  EXPECT_EQ(world.find_cloth("sheet"), cloth);
  EXPECT_EQ(future_of(world, steps), future);
}

TEST_P(SnapshotTest, RefusesWhatItCannotBringBack) {
  World world = dam_break(GetParam()), other = dam_break(GetParam());
  const Snapshot snapshot = world.snapshot();
  expect_error(ErrorCode::invalid_argument, "of another world", [&] { other.restore(snapshot); });
  expect_error(ErrorCode::invalid_argument, "of no world", [&] { world.restore({}); });
}

TEST_P(SnapshotTest, OutlivesItsWorld) {
  Snapshot snapshot;
  EXPECT_TRUE(snapshot.empty());
  {
    World world = dam_break(GetParam());
    world.step(snapshot_step);
    snapshot = world.snapshot();
    EXPECT_GT(snapshot.device_bytes(), 0u);
    EXPECT_EQ(snapshot.time(), world.time());
  }
  EXPECT_FALSE(snapshot.empty());
  EXPECT_EQ(snapshot.device_bytes(), 0u);
  World another = dam_break(GetParam());
  expect_error(ErrorCode::invalid_argument, "of another world", [&] { another.restore(snapshot); });
}

/// The sinks and callbacks of the snapshot's time may be gone.
TEST_P(SnapshotTest, ARestoreKeepsWhatBelongsToTheProgram) {
  int before = 0, now = 0;
  WorldDef def = world_def(GetParam());
  def.log = [&](LogLevel, const std::string&) { ++before; };
  World world = dam_break(def);
  const Snapshot snapshot = world.snapshot();
  def.log = [&](LogLevel, const std::string&) { ++now; };
  def.read_file = [](const std::string&) { return std::nullopt; };
  world.set_def(def);
  before = now = 0;
  world.restore(snapshot);
  ASSERT_TRUE(world.def().read_file);
  world.set_def(world.def());
  const World clone = world.clone();
  EXPECT_EQ(before, 0);
  EXPECT_GT(now, 0) << "the clone tells its device";
}

TEST_P(SnapshotTest, FindsByName) {
  World world = dam_break(GetParam());
  EXPECT_EQ(world.find_shape("tank"), world.shape_ids().at(0));
  EXPECT_EQ(world.find_fluid("water"), world.fluid_ids().at(0));
  expect_error(ErrorCode::not_found, "no body is called \"boat\"", [&] { world.find_body("boat"); });
}

MENISCUS_ON_EACH_DEVICE(SnapshotTest);

}  // namespace
}  // namespace meniscus::tests
