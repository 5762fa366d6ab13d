// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Worlds whose device solves contacts among solids. Its laws are in
// tests/unit/collision/rigid/device_test.cpp.
#include <gtest/gtest.h>

#include "tests/many_threads.h"
#include "tests/unit/sdk/world/solids/body_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float half = 0.1f, dt = 0.004f;

WorldDef device_def(pbd::DeviceKind device, float spacing = 0.05f) {
  WorldDef def = world_def(device, spacing);
  def.rigid.solver = RigidSolver::device;
  return def;
}

/// Cubes on one another in an open tank.
std::vector<BodyId> stack(World& world, int count) {
  world.create_shape(open_tank({0.5f, 0.5f, 0.5f}));
  std::vector<BodyId> bodies;
  for (int k = 0; k < count; ++k) {
    const float y = half * (2 * static_cast<float>(k) + 1);
    bodies.push_back(world.create_body(body(BoxGeometry{{half, half, half}}, {0, y, 0})));
  }
  return bodies;
}

}  // namespace

class RigidSolverTest : public OnDevice {};

TEST_P(RigidSolverTest, AStackStands) {
  World world(device_def(GetParam()));
  const std::vector<BodyId> bodies = stack(world, 4);
  run(world, 250, dt);
  expect_near(world.body_state(bodies.back()).pose.position, {0, 7 * half, 0}, 0.001f);
}

// A wooden box with three fifths of the density of water.
TEST_P(RigidSolverTest, ABoxFloatsAtItsDraft) {
  constexpr float s = 0.05f;
  World world(device_def(GetParam(), s));
  world.create_shape(open_tank({0.4f, 0.5f, 0.4f}));
  BodyDef def = body(BoxGeometry{{0.2f, 0.1f, 0.2f}}, {0, 0.42f, 0});
  def.density = 600;
  const BodyId box = world.create_body(def);
  const FluidId water = world.create_fluid({});
  world.add_fluid(block(water, {-0.4f, 0, -0.4f}, {0.4f, 0.4f, 0.4f}));
  run(world, 150, 0.016f);
  const BodyState state = world.body_state(box);
  EXPECT_LT(length(state.velocity), 0.1f);
  // The displaced water raises the level, here by less than a spacing.
  EXPECT_NEAR(state.pose.position.y, 0.4f + 0.1f - 0.12f, s);
}

TEST_P(RigidSolverTest, ARestoredWorldContinuesWithTheSameBits) {
  World world(device_def(GetParam()));
  const std::vector<BodyId> bodies = stack(world, 4);
  world.apply_impulse(bodies[3], {2, 0, 0.3f}, {0, 7.5f * half, 0});
  run(world, 20, dt);
  const Snapshot snapshot = world.snapshot();
  run(world, 20, dt);
  const uint64_t hash = world.state_hash();
  world.restore(snapshot);
  run(world, 20, dt);
  EXPECT_EQ(world.state_hash(), hash);
}

TEST_P(RigidSolverTest, AfterAFailedStepItContinuesWithTheSameBits) {
  World world(device_def(GetParam())), twin(device_def(GetParam()));
  for (World* each : {&world, &twin}) {
    const std::vector<BodyId> bodies = stack(*each, 4);
    each->apply_impulse(bodies[3], {2, 0, 0.3f}, {0, 7.5f * half, 0});
    run(*each, 20, dt);
  }
  const std::vector<SolidContact> before = world.solid_contacts();
  ASSERT_GT(before.size(), 8u);
  expect_error(ErrorCode::non_finite, "became non-finite", [&] { world.step(1e20f); });
  EXPECT_EQ(world.solid_contacts().size(), before.size());
  for (World* each : {&world, &twin}) run(*each, 20, dt);
  EXPECT_EQ(world.state_hash(), twin.state_hash());
  EXPECT_EQ(world.contact_events().size(), twin.contact_events().size());
}

TEST_P(RigidSolverTest, ARestoredWorldHasBodiesThatWereDestroyedSince) {
  World world(device_def(GetParam()));
  const std::vector<BodyId> bodies = stack(world, 4);
  run(world, 20, dt);
  const Snapshot snapshot = world.snapshot();
  run(world, 20, dt);
  const uint64_t hash = world.state_hash();
  world.restore(snapshot);
  world.destroy_body(bodies[1]);
  run(world, 5, dt);
  world.restore(snapshot);
  run(world, 20, dt);
  EXPECT_EQ(world.state_hash(), hash);
}

TEST_P(RigidSolverTest, RaysMeetBodiesWhereTheyAre) {
  World world(device_def(GetParam()));
  const BodyId ball = world.create_body(body(SphereGeometry{half}, {0, 5, 0}));
  run(world, 125, dt);
  const float y = world.body_state(ball).pose.position.y;
  ASSERT_LT(y, 4);
  const std::optional<RayHit> hit = world.cast_ray({-2, y, 0}, {2, y, 0});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->point.x, -half, 0.001f);
}

TEST_P(RigidSolverTest, RefusesWhatTheDeviceHasNot) {
  World world(device_def(GetParam()));
  expect_error(ErrorCode::invalid_argument, "no cylinders", [&] {
    world.create_body(body(CylinderGeometry{0.1f, 0.1f}));
  });
  EXPECT_TRUE(world.body_ids().empty());
  const BodyId box = world.create_body(body(BoxGeometry{{half, half, half}}));
  expect_error(ErrorCode::invalid_argument, "no joints",
               [&] { world.create_joint(joint(BallJoint{}, box)); });
  EXPECT_TRUE(world.joint_ids().empty());
  WorldDef def = world.def();
  def.rigid.solver = RigidSolver::bullet;
  expect_error(ErrorCode::invalid_argument, "WorldDef::rigid.solver", [&] { world.set_def(def); });
  run(world, 2, dt);
}

MENISCUS_ON_EACH_DEVICE(RigidSolverTest);

TEST(RigidSolverThreads, SameBitsWithAnyNumberOfThreads) {
  const ManyThreads many;
  uint64_t first = 0;
  for (const int threads : {1, 8}) {
    WorldDef def = device_def(pbd::DeviceKind::cpu);
    def.threads = threads;
    World world(def);
    const std::vector<BodyId> bodies = stack(world, 5);
    world.apply_impulse(bodies[4], {3, 0, 0.3f}, {0, 9.5f * half, 0});
    world.add_fluid(block(world.create_fluid({}), {-0.5f, 0, 0.2f}, {0.5f, 0.4f, 0.5f}));
    run(world, 30, dt);
    if (threads == 1)
      first = world.state_hash();
    else
      EXPECT_EQ(world.state_hash(), first);
  }
}

}  // namespace meniscus::tests
