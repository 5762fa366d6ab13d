// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A world in a batch moves bit for bit as it does alone.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/sdk/world/batch/batch_archetypes.h"
#include "tests/unit/sdk/world/batch/batch_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float dt = batch_dt;

class BatchTest : public BatchOnDevice {
 protected:
  World archetype(const WorldDef& def) const override { return fluids(def); }
};

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

TEST_P(BatchTest, ChecksItsArguments) {
  WorldBatch made = batch(3);
  made.step(dt);
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
