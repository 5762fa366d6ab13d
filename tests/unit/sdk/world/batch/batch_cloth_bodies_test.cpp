// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Bodies and cloth that meet in the worlds of a batch.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/sdk/world/batch/batch_archetypes.h"
#include "tests/unit/sdk/world/batch/batch_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float dt = batch_dt;

class BatchClothBodiesTest : public BatchOnDevice {
 protected:
  World archetype(const WorldDef& def) const override { return rigging(def).world; }
};

TEST_P(BatchClothBodiesTest, TheyMeet) {
  WorldBatch made = batch(2);
  run_batch(made, 40);
  const std::span<const BodyState> bodies = made.body_states();
  const BodyState &ball = bodies[0], &crate = bodies[1];
  const Vec3 middle = made.cloth_positions()[31];
  EXPECT_LT(middle.y, 0.34f) << "the ball and the water bend the net";
  EXPECT_GT(ball.pose.position.y, 0.15f) << "the net holds the ball";
  EXPECT_GT(crate.velocity.y, -3.7f) << "the sail brakes the crate";
  const Vec3 sail = made.cloth_positions()[9 * 7 + 14];
  EXPECT_LT(length(sail - crate.pose.position), 0.2f) << "the sail stays with the crate";
}

/// A fast body needs more substeps in its world alone.
TEST_P(BatchClothBodiesTest, WorldsWithFastBodiesStepInTurns) {
  const Rigging names = rigging(def());
  WorldBatch made(names.world, {5});
  run_batch(made, 5);
  World own = rigging(def()).world, still = rigging(def()).world;
  run(own, 5, dt);
  run(still, 5, dt);
  const Vec3 down{0, -40, 0};
  made.set_body_velocity(1, names.ball, down, {0, 0, 0});
  made.set_body_velocity(4, names.box, {-25, 0, 0}, {0, 0, 0});
  own.set_body_velocity(own.body_ids()[0], down, {0, 0, 0});
  const BatchReport report = made.step(dt);
  const int substeps = own.step(dt).substeps;
  EXPECT_GE(report.substeps, substeps);
  EXPECT_GE(report.turns, 2);
  EXPECT_EQ(report.stepped, 5u);
  EXPECT_GT(substeps, def().substeps);
  EXPECT_EQ(still.step(dt).substeps, def().substeps);
  run_batch(made, 15);
  run(own, 15, dt);
  run(still, 15, dt);
  EXPECT_EQ(made.state_hashes()[1], own.state_hash());
  for (const uint32_t w : {0u, 2u, 3u}) EXPECT_EQ(made.state_hashes()[w], still.state_hash()) << w;
  EXPECT_NE(made.state_hashes()[4], still.state_hash());
  EXPECT_FLOAT_EQ(static_cast<float>(made.status()[1].time), 21 * dt);
}

TEST_P(BatchClothBodiesTest, TurnsAllocateNothingOnceWarm) {
  const Rigging names = rigging(def());
  WorldBatch made(names.world, {3});
  const auto throw_and_step = [&] {
    made.reset();
    made.set_body_velocity(1, names.ball, {0, -40, 0}, {0, 0, 0});
    EXPECT_GT(made.step(dt).turns, 1);
  };
  for (int k = 0; k < 3; ++k) throw_and_step();
  const size_t before = made.memory_stats().device.allocations;
  throw_and_step();
  EXPECT_EQ(made.memory_stats().device.allocations, before);
}

/// What the solve leaves of a very fast impact, the fail-safe settles: in one world, as alone.
TEST_P(BatchClothBodiesTest, TheFailSafeActsInOneWorld) {
  const auto shot = [&](const WorldDef& def) {
    World world(def);
    ClothDef target = sheet(0.4f, 0.4f, 9, 9, {0, 0.3f, 0});
    world.create_cloth(without_self_collision(target));
    BodyDef bullet = validation::body(SphereGeometry{0.02f}, {0.013f, 0.5f, 0.021f}, 8000);
    world.create_body(bullet);
    return world;
  };
  World own = shot(def());
  const BodyId bullet = own.body_ids()[0];
  WorldBatch made(own, {4});
  World still = shot(def());
  made.set_body_velocity(2, bullet, {0, -150, 0}, {0, 0, 0});
  own.set_body_velocity(bullet, {0, -150, 0}, {0, 0, 0});
  for (int k = 0; k < 6; ++k) {
    made.step(dt);
    own.step(dt);
    still.step(dt);
    EXPECT_EQ(made.state_hashes()[2], own.state_hash()) << "step " << k;
    EXPECT_EQ(made.state_hashes()[3], still.state_hash()) << "step " << k;
  }
  EXPECT_LT(own.cloth_positions(own.cloth_ids()[0])[40].y, 0.1f) << "the bullet takes the cloth along";
}

/// Curtains hang from a rod that a call moves.
TEST_P(BatchClothBodiesTest, AMovedBodyTakesItsClothAlong) {
  const Rigging names = rigging(def());
  WorldBatch made(names.world, {3});
  World own = rigging(def()).world;
  Pose target;
  target.position = {0.9f, 0.9f, 0.25f};
  made.move_body(1, names.rod, target, 0.1f);
  own.move_body(own.body_ids()[2 + 1], target, 0.1f);
  run_batch(made, 20);
  run(own, 20, dt);
  EXPECT_EQ(made.state_hashes()[1], own.state_hash());
  EXPECT_NE(made.state_hashes()[0], own.state_hash());
}

TEST_P(BatchClothBodiesTest, AnInsertedWorldHasTheSameAttachments) {
  WorldBatch made(rigging(def()).world, {2});
  World other = rigging(def()).world;
  other.destroy_attachment(other.attachment_ids().back());
  const std::string refusal = refusal_of([&] { made.insert(0, other); });
  EXPECT_NE(refusal.find("attached"), std::string::npos) << refusal;
}

MENISCUS_ON_EACH_DEVICE(BatchClothBodiesTest);

}  // namespace
}  // namespace meniscus::tests
