// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// When bodies fall asleep and wake whose contacts a device solves, beyond what sleep_test.cpp has of both
// solvers.
#include <gtest/gtest.h>

#include "tests/unit/collision/rigid/device_scene.h"

namespace meniscus::collision {

namespace {

constexpr float dt = 0.004f, half = 0.05f;

const RigidPart cube = box_part({half, half, half});

/// A stack of cubes on the ground, and one far from it.
struct SleepingStack {
  static constexpr uint32_t count = 4, apart = count;
  DeviceWorld d;
  uint32_t ground;

  explicit SleepingStack(int steps = 1000) : ground(d.world.add_fixed(fixed_solid(plane_part()))) {
    for (uint32_t k = 0; k < count; ++k)
      d.world.add_body(body_def(cube, {0, half * (2.0f * static_cast<float>(k) + 1), 0}));
    d.world.add_body(body_def(cube, {2, half, 0}));
    run(d.world, dt, steps);
  }
  uint32_t awake() const {
    uint32_t sum = 0;
    for (uint32_t n = 0; n < count; ++n) sum += d.world.awake(n);
    return sum;
  }
};

}  // namespace

TEST(RigidDeviceSleep, AnIslandSleepsAndWakesAsAWhole) {
  SleepingStack stack;
  RigidWorld& world = stack.d.world;
  EXPECT_EQ(stack.awake(), 0u);
  EXPECT_FALSE(world.awake(stack.apart));
  run(world, dt, 1);
  EXPECT_TRUE(stack.d.contacts.found().empty()) << "it costs nothing";
  EXPECT_EQ(world.touches().size(), 5u) << "but touches";
  const float height = world.pose(3).position.y;
  world.wake(1);
  run(world, dt, 1);
  EXPECT_EQ(stack.awake(), 4u);
  EXPECT_FALSE(world.awake(stack.apart));
  EXPECT_LT(length(world.velocity(3)), 1e-3f) << "it starts from the forces that it slept with";
  EXPECT_NEAR(world.pose(3).position.y, height, 1e-5f);
}

TEST(RigidDeviceSleep, WhatHitsASleeperWakesItInThatStep) {
  SleepingStack stack;
  RigidWorld& world = stack.d.world;
  RigidBodyDef ball = body_def({round_part(Kind::sphere, half)}, {{0.3f, 5 * half, 0}, no_turn});
  ball.velocity = {-3, 0, 0};
  const uint32_t thrown = world.add_body(ball);
  const float momentum = -3 / world.mass(thrown).inverse_mass;
  for (int k = 0; k < 100 && stack.awake() == 0; ++k) run(world, dt, 1);
  EXPECT_EQ(stack.awake(), 4u);
  run(world, dt, 2);
  float sum = 0;
  for (const uint32_t n : {0u, 1u, 2u, 3u, thrown}) sum += world.velocity(n).x / world.mass(n).inverse_mass;
  EXPECT_NEAR(sum, momentum, 0.15f * -momentum);  // the ground rubs
  EXPECT_FALSE(world.awake(stack.apart));
}

TEST(RigidDeviceSleep, SomeNeverDo) {
  DeviceWorld d;
  d.world.add_fixed(fixed_solid(plane_part()));
  RigidBodyDef def = body_def(cube, {0, half, 0});
  def.can_sleep = false;
  d.world.add_body(def);
  d.world.add_body(body_def(cube, {0, 3 * half, 0}));
  run(d.world, dt, 1000);
  EXPECT_TRUE(d.world.awake(0));
  EXPECT_TRUE(d.world.awake(1)) << "which lies on it";
}

TEST(RigidDeviceSleep, ARestoredSleeperWakesWithTheSameBits) {
  SleepingStack stack;
  RigidWorld& world = stack.d.world;
  const RigidWorld::SnapshotPtr saved = RigidWorld::make_snapshot();
  world.save(*saved);
  const auto go_on = [&] {
    run(world, dt, 5);
    world.apply_impulse(2, {0.5f, 0, 0.1f}, {0, 5.5f * half, 0});
    run(world, dt, 100);
    return hash_of(world);
  };
  const uint64_t hash = go_on();
  world.restore(*saved);
  EXPECT_EQ(stack.awake(), 0u);
  EXPECT_EQ(world.touches().size(), 5u);
  EXPECT_EQ(go_on(), hash);
}

}  // namespace meniscus::collision
