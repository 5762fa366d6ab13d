// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of when rigid bodies fall asleep and wake.
#include <gtest/gtest.h>

#include "tests/unit/collision/rigid/solvers.h"

namespace meniscus::collision {

namespace {

constexpr float dt = 0.004f, weight = 8 * 9.81f;

/// A cube of 8 kg that a steady push has put to rest in mid-air, as water does.
struct Afloat {
  SolverWorld world;
  uint32_t body = world.add_body(body_def(box_part({0.1f, 0.1f, 0.1f}), {0, 0, 0}));

  explicit Afloat(Solver solver) : world(solver) {
    for (int i = 0; i < 1000 && world.awake(body); ++i) push(weight);
  }
  void push(float force, float torque = 0) {
    world.step(dt, std::vector<RigidImpulse>{{{0, force * dt, 0}, {0, 0, torque * dt}}});
  }
};

}  // namespace

class RigidSleepTest : public OnSolver {};
MENISCUS_WITH_EACH_SOLVER(RigidSleepTest);

TEST_P(RigidSleepTest, ABodyThatIsHeldUpFallsAsleep) {
  Afloat afloat(GetParam());
  EXPECT_FALSE(afloat.world.awake(afloat.body));
  std::vector<RigidMotion> motion(1);
  afloat.world.predict(dt, motion);
  EXPECT_NEAR(motion[0].velocity.y, -9.81f * dt, 1e-3f * 9.81f * dt) << "it presses as before";
  const Pose before = afloat.world.pose(afloat.body);
  for (int i = 0; i < 100; ++i) afloat.push(weight * (i % 2 ? 1.05f : 0.95f));  // a little noise
  EXPECT_FALSE(afloat.world.awake(afloat.body));
  EXPECT_EQ(afloat.world.pose(afloat.body).position, before.position);
}

TEST_P(RigidSleepTest, AChangeOfThePushWakes) {
  for (const float share : {0.0f, 0.85f, 1.15f}) {
    Afloat afloat(GetParam());
    afloat.push(share * weight);
    EXPECT_TRUE(afloat.world.awake(afloat.body));
    EXPECT_NEAR(afloat.world.velocity(afloat.body).y, (share - 1) * 9.81f * dt, 2e-3f);
  }
  Afloat afloat(GetParam());
  afloat.push(weight, 0.2f * weight * 0.18f);
  EXPECT_TRUE(afloat.world.awake(afloat.body));
}

TEST_P(RigidSleepTest, SoDoesTheUser) {
  const auto wakes = [](auto&& call) {
    Afloat afloat(GetParam());
    ASSERT_FALSE(afloat.world.awake(afloat.body));
    call(afloat.world, afloat.body);
    EXPECT_TRUE(afloat.world.awake(afloat.body));
    afloat.push(weight);
    EXPECT_TRUE(afloat.world.awake(afloat.body));
  };
  wakes([](RigidWorld& w, uint32_t b) { w.wake(b); });
  wakes([](RigidWorld& w, uint32_t b) { w.apply_force(b, {1, 0, 0}, {0, 0, 0}); });
  wakes([](RigidWorld& w, uint32_t b) { w.apply_torque(b, {1, 0, 0}); });
  wakes([](RigidWorld& w, uint32_t b) { w.apply_impulse(b, {1, 0, 0}, {0, 0, 0}); });
  wakes([](RigidWorld& w, uint32_t b) { w.set_velocity(b, {1, 0, 0}, {0, 0, 0}); });
  wakes([](RigidWorld& w, uint32_t b) { w.set_pose(b, {{1, 0, 0}, no_turn}); });
}

TEST_P(RigidSleepTest, AnIslandSleepsAndWakesAsAWhole) {
  SolverWorld world(GetParam());
  world.add_fixed(fixed_solid(plane_part()));
  for (int i = 0; i < 6; ++i) {
    world.add_body(body_def(box_part({0.1f, 0.1f, 0.1f}), {0.199f * static_cast<float>(i), 0.1f, 0}));
  }
  const uint32_t apart = world.add_body(body_def(box_part({0.1f, 0.1f, 0.1f}), {5, 0.1f, 0}));
  run(world, dt, 1500);
  for (uint32_t body = 0; body <= apart; ++body) EXPECT_FALSE(world.awake(body)) << body;
  world.apply_impulse(0, {0.5f, 0, 0}, {0, 0.1f, 0});
  run(world, dt, 3);
  for (uint32_t body = 0; body < apart; ++body) EXPECT_TRUE(world.awake(body)) << body;
  EXPECT_FALSE(world.awake(apart));
}

TEST_P(RigidSleepTest, WhatLosesItsSupportFalls) {
  for (const bool removed : {true, false}) {
    SolverWorld world(GetParam());
    const uint32_t table = world.add_fixed(fixed_solid(box_part({1, 0.1f, 1}), {{0, -0.1f, 0}, no_turn}));
    const uint32_t lower = world.add_body(body_def(box_part({0.1f, 0.1f, 0.1f}), {0, 0.1f, 0}));
    const uint32_t upper = world.add_body(body_def(box_part({0.1f, 0.1f, 0.1f}), {0, 0.3f, 0}));
    run(world, dt, 1500);
    ASSERT_FALSE(world.awake(upper));
    if (removed) {
      world.remove(RigidRef{true, lower});
    } else {
      world.set_pose(lower, {{5, 0.1f, 0}, no_turn});
    }
    run(world, dt, 50);
    EXPECT_LT(world.pose(upper).position.y, 0.25f);
    run(world, dt, 1500);
    world.remove(RigidRef{false, table});
    run(world, dt, 100);
    EXPECT_LT(world.pose(upper).position.y, -0.1f);
  }
}

TEST_P(RigidSleepTest, AMovingFloorWakesWhatLiesOnIt) {
  SolverWorld world(GetParam());
  const uint32_t floor = world.add_body(kinematic_def({box_part({1, 0.1f, 1})}, {{0, -0.1f, 0}, no_turn}));
  const uint32_t box = world.add_body(body_def(box_part({0.1f, 0.1f, 0.1f}), {0, 0.1f, 0}));
  run(world, dt, 1500);
  EXPECT_FALSE(world.awake(box));
  world.move(floor, {{0, 0.9f, 0}, no_turn}, 2);
  run(world, dt, 250);
  EXPECT_TRUE(world.awake(box));
  EXPECT_NEAR(world.pose(box).position.y, 0.6f, 0.01f);
}

TEST(RigidSleep, AMovingCarrierWakesWhatHangsFromIt) {
  RigidWorld world({});
  const uint32_t crane = world.add_body(kinematic_def({box_part({0.1f, 0.1f, 0.1f})}, {{0, 2, 0}, no_turn}));
  const uint32_t load = world.add_body(body_def(box_part({0.1f, 0.1f, 0.1f}), {0, 1, 0}));
  RigidJointDef rope;
  rope.a = crane;
  rope.b = load;
  rope.frame = {{0, 2, 0}, no_turn};
  rope.kind = BallJoint{};
  world.add_joint(rope);
  run(world, dt, 1500);
  EXPECT_FALSE(world.awake(load));
  world.move(crane, {{0, 3, 0}, no_turn}, 2);
  run(world, dt, 600);
  EXPECT_NEAR(world.pose(load).position.y, 2, 0.02f);
}

TEST_P(RigidSleepTest, WhatDriftsWithoutGravityDriftsOn) {
  SolverWorld world(GetParam(), {.gravity = {0, 0, 0}});
  RigidBodyDef def = body_def(box_part({0.1f, 0.1f, 0.1f}), {0, 0, 0});
  def.velocity = {0.002f, 0, 0};
  def.angular_velocity = {0, 0.01f, 0};
  const uint32_t box = world.add_body(def);
  run(world, dt, 2500);
  EXPECT_TRUE(world.awake(box));
  EXPECT_NEAR(world.pose(box).position.x, 0.02f, 1e-4f);
  EXPECT_NEAR(2 * world.pose(box).rotation.y, 0.1f, 1e-3f);
}

TEST_P(RigidSleepTest, WhoIsKeptAwakeStaysSo) {
  Afloat afloat(GetParam());
  afloat.world.keep_awake(std::vector{afloat.body});
  EXPECT_TRUE(afloat.world.awake(afloat.body));
  for (int i = 0; i < 1000; ++i) afloat.push(weight);
  EXPECT_TRUE(afloat.world.awake(afloat.body));
  afloat.world.keep_awake({});
  for (int i = 0; i < 1000; ++i) afloat.push(weight);
  EXPECT_FALSE(afloat.world.awake(afloat.body));
}

TEST_P(RigidSleepTest, SomeNeverDo) {
  SolverWorld world(GetParam());
  world.add_fixed(fixed_solid(plane_part()));
  RigidBodyDef def = body_def(box_part({0.1f, 0.1f, 0.1f}), {0, 0.1f, 0});
  def.can_sleep = false;
  const uint32_t box = world.add_body(def);
  run(world, dt, 1500);
  EXPECT_TRUE(world.awake(box));
}

TEST(RigidSleep, WhatAMotorPressesStaysAwake) {
  for (const float force : {0.0f, 5.0f}) {
    RigidWorld world({});
    RigidJointDef def;
    def.a = world.add_body(body_def(box_part({0.1f, 0.1f, 0.1f}), {0, 0, 0}));
    def.kind = SliderJoint{.lower = 0.0f, .upper = 0.1f, .motor_speed = 1, .motor_force = force};
    world.add_joint(def);
    run(world, dt, 1000);
    EXPECT_EQ(world.awake(def.a), force > 0);
  }
}

}  // namespace meniscus::collision
