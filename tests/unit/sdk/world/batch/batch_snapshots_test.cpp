// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A batch goes on from a snapshot, in memory or in a file, as it went on before.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <optional>

#include "tests/unit/sdk/world/batch/batch_worlds.h"

namespace meniscus::tests {
namespace {

class BatchSnapshotsTest : public OnDevice {
 protected:
  /// A tank with water and a body that floats.
  World archetype() const {
    World world(batch_def(GetParam()));
    const FluidId water = world.create_fluid({});
    world.create_shape(tank({0, 0, 0}, {0.8f, 0.8f, 0.4f}));
    world.create_body(validation::body(SphereGeometry{0.1f}, {0.5f, 0.6f, 0.2f}, 400));
    world.add_fluid(block(water, {0, 0, 0}, {0.4f, 0.4f, 0.4f}));
    return world;
  }
  /// Worlds that differ in gravity, of which one waits and one has failed.
  WorldBatch batch() const {
    WorldBatch made(archetype(), {4});
    made.set_gravities(std::vector<Vec3>{gravity_of(0), gravity_of(1), {0, 1e30f, 0}, gravity_of(3)});
    run_batch(made, 10);
    made.set_active(mask_of(4, {0, 2, 3}));
    run_batch(made, 5);
    return made;
  }
  static std::vector<uint64_t> hashes(const WorldBatch& batch) {
    return {batch.state_hashes().begin(), batch.state_hashes().end()};
  }
  /// The hashes after steps in which all worlds take part, as far as they can.
  static std::vector<uint64_t> after(WorldBatch& batch) {
    batch.set_active(mask_of(4, {0, 1, 2, 3}));
    run_batch(batch, 10);
    return hashes(batch);
  }
  static std::string path() {
    const std::string name = "meniscus_batch_" + std::to_string(getpid()) + ".menisnap";
    return (std::filesystem::path(::testing::TempDir()) / name).string();
  }
};

TEST_P(BatchSnapshotsTest, GoesOnAsBefore) {
  WorldBatch made = batch();
  const BatchSnapshot snapshot = made.snapshot();
  const std::vector<uint64_t> then = hashes(made), later = after(made);
  made.set_gravity(0, {1, -5, 0});
  run_batch(made, 5);
  made.restore(snapshot);
  EXPECT_EQ(hashes(made), then);
  EXPECT_TRUE(made.status()[2].failed);
  EXPECT_FALSE(made.status()[1].active);
  EXPECT_FLOAT_EQ(static_cast<float>(made.status()[1].time), 10 * batch_dt);
  EXPECT_EQ(after(made), later);
  EXPECT_NE(then, later);
}

TEST_P(BatchSnapshotsTest, AFileGoesOnAsBefore) {
  WorldBatch made = batch();
  made.save(path());
  const std::vector<uint64_t> later = after(made);
  WorldBatch loaded = WorldBatch::load(path());
  EXPECT_EQ(loaded.worlds(), 4u);
  EXPECT_TRUE(loaded.status()[2].failed);
  EXPECT_EQ(after(loaded), later);
  loaded.reset(mask_of(4, {1}));
  EXPECT_EQ(loaded.state_hashes()[1], archetype().state_hash());
  loaded.apply_force(0, loaded.body_ids().front(), {0, 50, 0});
  EXPECT_THROW(World::load(path()), Error) << "of a batch";
  std::filesystem::remove(path());
}

TEST_P(BatchSnapshotsTest, RefusesThoseOfOthers) {
  WorldBatch one = batch();
  std::optional<WorldBatch> other(batch());
  BatchSnapshot snapshot = other->snapshot();
  EXPECT_GT(snapshot.device_bytes(), 0u);
  EXPECT_NE(refusal_of([&] { one.restore(snapshot); }).find("another batch"), std::string::npos);
  EXPECT_NE(refusal_of([&] { one.restore({}); }).find("no batch"), std::string::npos);
  other.reset();
  EXPECT_EQ(snapshot.device_bytes(), 0u) << "they go with the device";
  archetype().save(path());
  EXPECT_THROW(WorldBatch::load(path()), Error) << "of a world";
  std::filesystem::remove(path());
}

MENISCUS_ON_EACH_DEVICE(BatchSnapshotsTest);

}  // namespace
}  // namespace meniscus::tests
