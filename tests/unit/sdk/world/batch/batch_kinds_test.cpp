// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What holds for worlds of each kind in a batch: they have the bits of a world alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "tests/unit/sdk/world/batch/batch_archetypes.h"
#include "tests/unit/sdk/world/batch/batch_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float dt = batch_dt;

/// A kind of world, and how many steps show what is in it.
struct Kind {
  const char* name;
  World (*make)(const WorldDef& def);
  int steps, steps_of_many;
};

const Kind kinds[] = {
    {"fluids", fluids, 25, 25},
    {"bodies", [](const WorldDef& def) { return pool(def).world; }, 40, 20},
    {"cloth", [](const WorldDef& def) { return washing(def); }, 40, 10},
    {"folds", folding, 40, 10},
    {"cloth_and_bodies", [](const WorldDef& def) { return rigging(def).world; }, 40, 10},
    {"grains", sandpit, 40, 20},
};

class BatchKindsTest : public testing::TestWithParam<std::tuple<pbd::DeviceKind, Kind>>, protected BatchRuns {
 protected:
  pbd::DeviceKind device() const override { return std::get<0>(GetParam()); }
  const Kind& kind() const { return std::get<1>(GetParam()); }
  World archetype(const WorldDef& def) const override { return kind().make(def); }
};

TEST_P(BatchKindsTest, AWorldIsAsItIsAlone) {
  expect_as_alone(1, 2, 1, kind().steps);
  expect_as_alone(7, 0, 1, kind().steps);
}

TEST_P(BatchKindsTest, SoItIsAtAnyPlaceAmongMany) {
  expect_as_alone(many(), 3, 2, kind().steps_of_many);
}

TEST_P(BatchKindsTest, AResetWorldIsAFreshOne) {
  WorldBatch made = batch(4);
  run_batch(made, 25);
  made.reset(mask_of(4, {1, 3}));
  EXPECT_EQ(made.state_hashes()[3], of_kind(3).state_hash());
  EXPECT_EQ(made.status()[3].time, 0);
  run_batch(made, 100);
  for (uint32_t w = 0; w < 4; ++w)
    EXPECT_EQ(made.state_hashes()[w], alone(w, w % 2 ? 100 : 125)) << "world " << w;
}

/// What the archetype's solve starts from is of that state: pressures, warm starts of edges and bodies,
/// contacts of grains, anchors of vertices that stick, the time of gusts.
TEST_P(BatchKindsTest, StartsInAnyState) {
  World world = archetype(def());
  run(world, 30, dt);
  WorldBatch made(world, {3});
  EXPECT_EQ(made.state_hashes()[2], world.state_hash());
  EXPECT_EQ(made.status()[1].time, world.time());
  run_batch(made, 15);
  made.reset(mask_of(3, {1}));
  EXPECT_EQ(made.state_hashes()[1], world.state_hash());
  run(world, 15, dt);
  EXPECT_EQ(made.state_hashes()[0], world.state_hash());
  run_batch(made, 15);
  EXPECT_EQ(made.state_hashes()[1], world.state_hash());
  run(world, 15, dt);
  EXPECT_EQ(made.state_hashes()[2], world.state_hash());
}

TEST_P(BatchKindsTest, AnExtractedWorldGoesOn) {
  WorldBatch made = batch(7);
  run_batch(made, 25);
  World world = made.extract(3);
  EXPECT_EQ(world.state_hash(), made.state_hashes()[3]);
  EXPECT_EQ(world.time(), made.status()[3].time);
  run(world, 15, dt);
  EXPECT_EQ(world.state_hash(), alone(3, 40));
}

TEST_P(BatchKindsTest, AnInsertedWorldGoesOn) {
  WorldBatch made = batch(3);
  run_batch(made, 5);
  World other = of_kind(4);
  run(other, 20, dt);
  made.insert(1, other);
  EXPECT_EQ(made.state_hashes()[1], other.state_hash());
  run(other, 20, dt);
  run_batch(made, 20);
  EXPECT_EQ(made.state_hashes()[1], other.state_hash());
  EXPECT_EQ(made.state_hashes()[2], alone(2, 25));
  made.reset(mask_of(3, {1}));
  EXPECT_EQ(made.state_hashes()[1], archetype(def()).state_hash());
}

TEST_P(BatchKindsTest, ASnapshotGoesOn) {
  WorldBatch made = batch(3);
  run_batch(made, 20);
  const BatchSnapshot then = made.snapshot();
  run_batch(made, 15);
  const std::vector<uint64_t> expected(made.state_hashes().begin(), made.state_hashes().end());
  made.restore(then);
  run_batch(made, 15);
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), made.state_hashes().begin()));
  EXPECT_EQ(expected[2], alone(2, 35));
}

TEST_P(BatchKindsTest, AWorldThatFailsGoesBackAlone) {
  WorldBatch made = batch(5);
  run_batch(made, 15);
  const uint64_t before = made.state_hashes()[4];
  made.set_gravity(4, {0, 1e30f, 0});
  const BatchReport report = made.step(dt);
  EXPECT_EQ(report.failed, 1u);
  EXPECT_EQ(report.stepped, 4u);
  EXPECT_EQ(made.state_hashes()[4], before);
  EXPECT_EQ(made.step(dt).failed, 0u) << "it waits for its reset";
  run_batch(made, 9);
  for (uint32_t w = 0; w < 4; ++w) EXPECT_EQ(made.state_hashes()[w], alone(w, 26)) << "world " << w;
  made.set_gravity(4, gravity_of(4));
  made.reset(mask_of(5, {4}));
  run_batch(made, 10);
  EXPECT_EQ(made.state_hashes()[4], alone(4, 10));
}

TEST_P(BatchKindsTest, APausedWorldStays) {
  WorldBatch made = batch(3);
  run_batch(made, 10);
  made.set_active(std::vector<uint8_t>{1, 0, 1});
  EXPECT_EQ(made.step(dt).stepped, 2u);
  run_batch(made, 9);
  EXPECT_EQ(made.state_hashes()[1], alone(1, 10));
  made.set_active(std::vector<uint8_t>(3, 1));
  run_batch(made, 10);
  for (uint32_t w = 0; w < 3; ++w)
    EXPECT_EQ(made.state_hashes()[w], alone(w, w == 1 ? 20 : 30)) << "world " << w;
}

/// A world's pressures and multipliers start from those of its own last step, whatever its length.
TEST_P(BatchKindsTest, StepsMayHaveAnyLength) {
  const auto step = [](auto& one_or_many) {
    for (const float length : {dt, dt, 0.5f * dt, 2 * dt, dt}) one_or_many.step(length);
  };
  WorldBatch made = batch(3);
  step(made);
  made.step(0.5f * dt);
  made.reset(mask_of(3, {1}));
  step(made);
  for (uint32_t w = 0; w < 3; ++w) {
    World own = of_kind(w);
    step(own);
    if (w != 1) {
      own.step(0.5f * dt);
      step(own);
    }
    EXPECT_EQ(made.state_hashes()[w], own.state_hash()) << "world " << w;
  }
}

TEST_P(BatchKindsTest, AWarmStepAllocatesNothing) {
  WorldBatch made = batch(4);
  for (int k = 0; k < 2; ++k) {
    run_batch(made, 60);
    made.reset(mask_of(4, {1, 2}));
  }
  run_batch(made, 5);
  const size_t before = made.memory_stats().device.allocations;
  made.reset(mask_of(4, {1, 3}));
  run_batch(made, 20);
  EXPECT_EQ(made.memory_stats().device.allocations, before);
}

INSTANTIATE_TEST_SUITE_P(On, BatchKindsTest,
                         testing::Combine(testing::ValuesIn(usable_devices()), testing::ValuesIn(kinds)),
                         [](const auto& made) {
                           return testing::PrintToString(std::get<0>(made.param)) + "_" +
                                  std::get<1>(made.param).name;
                         });

}  // namespace
}  // namespace meniscus::tests
