// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A call or a step that fails leaves no trace.
#include <gtest/gtest.h>

#include "tests/expect_error.h"
#include "tests/no_threads.h"
#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

constexpr float s = 0.1f;

class BodyFailureTest : public OnDevice {
 protected:
  static HullGeometry cube() {
    HullGeometry hull;
    for (int i = 0; i < 8; ++i)
      hull.points.push_back({i & 1 ? 0.3f : -0.3f, i & 2 ? 0.3f : -0.3f, i & 4 ? 0.3f : -0.3f});
    return hull;
  }

  /// A hull under falling water, and a box that floats on it.
  struct Pool {
    explicit Pool(pbd::DeviceKind device) : world(world_def(device, s)) {
      const FluidId water = world.create_fluid({});
      world.create_shape(tank({-0.6f, -0.3f, -0.6f}, {0.6f, 2, 0.6f}));
      world.create_shape(shape(cube()));
      BodyDef def;
      def.geometry = BoxGeometry{{0.2f, 0.1f, 0.2f}};
      def.name = "raft";
      def.pose.position = {0, 1, 0};
      box = world.create_body(def);
      world.add_fluid(block(water, {-0.6f, -0.3f, -0.6f}, {0.6f, 0.8f, 0.6f}));
    }

    World world;
    BodyId box;
  };
};

TEST_P(BodyFailureTest, ACompoundWithOneBadPartLeavesTheFieldsInUse) {
  Pool pool(GetParam()), twin(GetParam());
  CompoundGeometry bad;
  bad.parts = {{cube(), {}}, {HullGeometry{{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0, 1}}}, {}}};
  expect_error(ErrorCode::invalid_argument, "span no volume", [&] {
    pool.world.create_shape(shape(bad, {5, 0, 0}));
  });
  run(pool.world, 5, 0.01f);
  run(twin.world, 5, 0.01f);
  EXPECT_EQ(pool.world.state_hash(), twin.world.state_hash());
}

TEST_P(BodyFailureTest, AFailedStepLeavesTheForcesAndNoContacts) {
  Pool pool(GetParam());
  run(pool.world, 40, 0.01f);
  const BodyState before = pool.world.body_state(pool.box);
  EXPECT_GT(before.fluid_force.y, 1);
  expect_error(ErrorCode::non_finite, "non-finite", [&] { pool.world.step(1e20f); });
  EXPECT_EQ(pool.world.body_state(pool.box).fluid_force, before.fluid_force);
  EXPECT_TRUE(pool.world.particle_contacts().empty());
  pool.world.step(0.01f);
  EXPECT_FALSE(pool.world.particle_contacts().empty());
}

TEST_P(BodyFailureTest, ATorqueBeyondAllMeasureStopsTheStep) {
  Pool pool(GetParam());
  run(pool.world, 2, 0.01f);
  const uint64_t hash = pool.world.state_hash();
  pool.world.apply_torque(pool.box, {1e38f, 3e38f, -2e38f});
  expect_error(ErrorCode::non_finite, "the rigid body \"raft\" became", [&] { pool.world.step(0.01f); });
  EXPECT_EQ(pool.world.state_hash(), hash);
}

TEST_P(BodyFailureTest, AThreadThatCannotStartEndsTheStepAndNothingChanges) {
  Pool pool(GetParam()), twin(GetParam());
  const uint64_t hash = pool.world.state_hash();
  {
    const NoThreads none;
    for (int i = 0; i < 2; ++i)
      expect_error(ErrorCode::out_of_memory, "could not be started", [&] { pool.world.step(0.01f); });
  }
  EXPECT_EQ(pool.world.state_hash(), hash);
  run(pool.world, 3, 0.01f);
  run(twin.world, 3, 0.01f);
  EXPECT_EQ(pool.world.state_hash(), twin.world.state_hash());
}

MENISCUS_ON_EACH_DEVICE(BodyFailureTest);

}  // namespace
}  // namespace meniscus::tests
