// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Grains that were removed or added before a world came into a batch.
#include <gtest/gtest.h>

#include "tests/unit/sdk/world/batch/batch_archetypes.h"
#include "tests/unit/sdk/world/batch/batch_worlds.h"

namespace meniscus::tests {
namespace {

class BatchGrainsTest : public BatchOnDevice {
 protected:
  World archetype(const WorldDef& def) const override { return sandpit(def); }

  /// Sand whose grains press on one another, and of which every fifth particle has been removed since.
  World thinned() const {
    World world = archetype(def());
    run(world, 30, batch_dt);
    std::vector<ParticleId> gone;
    for (size_t i = 0; i < world.ids().size(); i += 5) gone.push_back(world.ids()[i]);
    world.remove_particles(gone);
    return world;
  }
};

TEST_P(BatchGrainsTest, StartsFromThoseThatRemain) {
  World world = thinned();
  WorldBatch made(world, {3});
  run_batch(made, 15);
  made.reset(mask_of(3, {1}));
  EXPECT_EQ(made.state_hashes()[1], world.state_hash());
  run_batch(made, 15);
  run(world, 15, batch_dt);
  EXPECT_EQ(made.state_hashes()[1], world.state_hash());
  run(world, 15, batch_dt);
  EXPECT_EQ(made.state_hashes()[2], world.state_hash());
}

TEST_P(BatchGrainsTest, TakesInAWorldThatHasLostSome) {
  World world = thinned();
  WorldBatch made(world, {3});
  run_batch(made, 5);
  made.insert(1, world);
  run_batch(made, 15);
  run(world, 15, batch_dt);
  EXPECT_EQ(made.state_hashes()[1], world.state_hash());
}

TEST_P(BatchGrainsTest, StartsFromGrainsThatCameLast) {
  World world = thinned();
  const FluidId fresh = world.create_granular({});
  world.add_fluid(block(fresh, {0, 0.8f, 0}, {0.6f, 1, 0.6f}));
  WorldBatch made(world, {3});
  made.insert(1, world);
  run_batch(made, 15);
  run(world, 15, batch_dt);
  for (uint32_t w = 0; w < 3; ++w) EXPECT_EQ(made.state_hashes()[w], world.state_hash()) << "world " << w;
}

MENISCUS_ON_EACH_DEVICE(BatchGrainsTest);

}  // namespace
}  // namespace meniscus::tests
