// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Memory that runs out while the worlds of a batch step in turns, or go back to a snapshot.
#include <algorithm>

#include "tests/cloth_worlds.h"
#include "tests/faults/failing_memory.h"

namespace meniscus::tests {
namespace {

constexpr float dt = 0.01f;

class BatchFaultsTest : public OnDevice {
 protected:
  void SetUp() override { forget_stacks(); }

  /// Worlds with a sheet, a ball, and a box that has begun to touch the floor. One ball is fast, so the
  /// worlds step in two turns.
  WorldBatch batch() const {
    WorldDef def = world_def(GetParam(), 0.05f);
    def.sums = Sums::fixed;
    def.substeps = 1;
    World world(def);
    world.create_cloth(sheet(0.4f, 0.4f, 4, 4, {0, 0.3f, 0}));
    const BodyId ball = world.create_body(validation::body(SphereGeometry{0.04f}, {0.01f, 0.4f, 0.02f}, 500));
    world.create_shape(shape(PlaneGeometry{}, {0, 0, 0}));
    world.create_body(validation::body(BoxGeometry{{0.05f, 0.05f, 0.05f}}, {1, 0.05f, 0}, 500));
    WorldBatch made(world, {2});
    made.step(dt);
    made.set_body_velocity(1, ball, {0, -20, 0}, {0, 0, 0});
    return made;
  }
  static std::vector<uint64_t> hashes(const WorldBatch& batch) {
    return {batch.state_hashes().begin(), batch.state_hashes().end()};
  }
  struct Outcome {
    bool fails, succeeds;  // memory, and the call
  };
  /// Calls where the next new call stack gets no memory.
  template <class Call>
  static Outcome without_memory(const Call& call) {
    const FailingMemory failing({});
    try {
      call();
    } catch (const Error&) {
      EXPECT_TRUE(failing.has_failed());
      return {failing.has_failed(), false};
    }
    return {failing.has_failed(), true};
  }
  static bool is_lost(const WorldBatch& batch) {
    try {
      batch.state_hashes();
    } catch (const Error& error) {
      EXPECT_EQ(static_cast<int>(error.code()), static_cast<int>(ErrorCode::lost)) << error.what();
      return true;
    }
    return false;
  }
};

TEST_P(BatchFaultsTest, ATurnThatFailsTakesBackAll) {
  WorldBatch reference = batch();
  const std::vector<uint64_t> before = hashes(reference);
  EXPECT_EQ(reference.contact_events(0).size(), 1u);
  EXPECT_EQ(reference.step(dt).turns, 2);
  EXPECT_TRUE(reference.contact_events(0).empty());
  const std::vector<uint64_t> after = hashes(reference);
  int failures = 0, losses = 0;
  for (bool fails = true; fails && !HasFailure();) {
    WorldBatch made = batch();
    const Outcome outcome = without_memory([&] { made.step(dt); });
    const bool succeeds = outcome.succeeds;
    fails = outcome.fails;
    failures += fails;
    if (!succeeds && is_lost(made)) {
      ++losses;
      continue;
    }
    EXPECT_EQ(hashes(made), succeeds ? after : before);
    EXPECT_EQ(made.contact_events(0).size(), succeeds ? 0u : 1u);
    if (HasFailure()) print_last_stack();
  }
  std::printf("%d failures, of which %d lost the batch\n", failures, losses);
  EXPECT_GT(failures, 30);
  EXPECT_LT(losses, failures / 4);
}

/// What was restored in part would be a state that nobody has asked for.
TEST_P(BatchFaultsTest, ARestoreThatFailsRestoresAllOrLosesTheBatch) {
  WorldBatch made = batch();
  BatchSnapshot snapshot = made.snapshot();
  const std::vector<uint64_t> saved = hashes(made);
  made.step(dt);
  const std::vector<uint64_t> before = hashes(made);
  int failures = 0, losses = 0;
  for (bool fails = true; fails && !HasFailure();) {
    const Outcome outcome = without_memory([&] { made.restore(snapshot); });
    const bool succeeds = outcome.succeeds;
    fails = outcome.fails;
    failures += fails;
    if (!succeeds && is_lost(made)) {
      ++losses;
      made = batch();
      snapshot = made.snapshot();
    } else {
      EXPECT_EQ(hashes(made), succeeds ? saved : before);
      if (HasFailure()) print_last_stack();
      made.restore(snapshot);
    }
    made.step(dt);
  }
  std::printf("%d failures, of which %d lost the batch\n", failures, losses);
  EXPECT_GT(failures, 30);
}

MENISCUS_ON_EACH_DEVICE(BatchFaultsTest);

}  // namespace
}  // namespace meniscus::tests
