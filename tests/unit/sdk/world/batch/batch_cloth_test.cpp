// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cloth of a world in a batch moves bit for bit as that of a world alone.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/sdk/world/batch/batch_archetypes.h"
#include "tests/unit/sdk/world/batch/batch_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float dt = batch_dt;

class BatchClothTest : public BatchOnDevice {
 protected:
  World archetype(const WorldDef& def) const override { return washing(def); }
};

TEST_P(BatchClothTest, WaterAndClothMeet) {
  WorldBatch made = batch(2);
  run_batch(made, 40);
  ASSERT_EQ(made.cloth_positions().size(), 2 * made.vertex_count());
  const float middle = made.cloth_positions()[31].y;
  EXPECT_LT(middle, 0.33f) << "the water bends the sheet";
  EXPECT_GT(middle, 0.1f) << "the sheet holds";
  const size_t in_sheet = static_cast<size_t>(std::count_if(made.positions().begin(),
                                                            made.positions().begin() + made.particle_count(),
                                                            [](Vec3 p) { return p.y > 0.15f; }));
  EXPECT_GT(in_sheet, made.particle_count() / 2) << "the sheet carries water";
}

TEST_P(BatchClothTest, ReadOutsAreThoseOfAWorldAlone) {
  WorldBatch made = batch(3);
  run_batch(made, 20);
  World own = of_kind(1);
  run(own, 20, dt);
  size_t first = made.vertex_count();
  for (const ClothId id : own.cloth_ids()) {
    const std::span<const Vec3> expected = own.cloth_positions(id);
    for (size_t v = 0; v < expected.size(); ++v)
      EXPECT_EQ(made.cloth_positions()[first + v], expected[v]) << "vertex " << v;
    first += expected.size();
  }
  EXPECT_EQ(first, 2 * made.vertex_count());
  const BatchArrays arrays = made.device_arrays();
  EXPECT_EQ(arrays.cloth_positions.shape[1], static_cast<int64_t>(made.vertex_count()));
  if (arrays.cloth_positions.on_cuda) return;
  const auto* const velocities = static_cast<const Vec3*>(arrays.cloth_velocities.data);
  EXPECT_TRUE(std::equal(made.cloth_velocities().begin(), made.cloth_velocities().end(), velocities));
}

/// Without fluid as well.
TEST_P(BatchClothTest, ClothMayBeAlone) {
  const auto flag = [&](Vec3 gravity) {
    WorldDef own = def();
    own.gravity = gravity;
    World world(own);
    const ClothId cloth = world.create_cloth(without_self_collision(sheet(0.5f, 0.5f, 8, 8, {0, 1, 0})));
    world.create_attachment(attach(cloth, {0, 7}));
    return world;
  };
  WorldBatch made(flag(gravity_of(0)), {3});
  made.set_gravities(std::vector<Vec3>{gravity_of(0), gravity_of(1), gravity_of(2)});
  run_batch(made, 30);
  for (uint32_t w = 0; w < 3; ++w) {
    World own = flag(gravity_of(w));
    run(own, 30, dt);
    EXPECT_EQ(made.state_hashes()[w], own.state_hash());
  }
}

TEST_P(BatchClothTest, InsertsTheSameClothAlone) {
  WorldBatch made = batch(2);
  World fewer = of_kind(0);
  fewer.destroy_cloth(fewer.cloth_ids().back());
  EXPECT_NE(refusal_of([&] { made.insert(0, fewer); }).find("pieces of cloth"), std::string::npos);
}

class BatchFoldingTest : public BatchOnDevice {
 protected:
  World archetype(const WorldDef& def) const override { return folding(def); }
};

/// The room of lists is that of the world with most, and all worlds have it.
TEST_P(BatchFoldingTest, MemoryIsLinearInWorlds) {
  const auto bytes = [&](uint32_t worlds) {
    WorldBatch made = batch(worlds, 0, 0);
    run_batch(made, 25);
    return static_cast<double>(made.memory_stats().device.bytes);
  };
  const double few = bytes(8), more = bytes(16), many = bytes(32);
  EXPECT_NEAR((many - more) / (2 * (more - few)), 1, 0.1);
}

MENISCUS_ON_EACH_DEVICE(BatchClothTest);
MENISCUS_ON_EACH_DEVICE(BatchFoldingTest);

}  // namespace
}  // namespace meniscus::tests
