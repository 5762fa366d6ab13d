// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Contacts among solids that a device solves: what Bullet's solver cannot do, and what the device alone has.
// contact_test.cpp has the laws of mechanics, with either solver.
#include <gtest/gtest.h>

#include <algorithm>

#include "pbd/device/cpu/cpu_device.h"
#include "tests/expect_error.h"
#include "tests/unit/collision/rigid/device_scene.h"

namespace meniscus::collision {

namespace {

constexpr float dt = 0.004f, half = 0.05f;

const RigidPart cube = box_part({half, half, half});

void lay_ground(RigidWorld& world) {
  world.add_fixed(fixed_solid(plane_part()));
}

RigidBodyDef sleepless(RigidBodyDef def) {
  def.can_sleep = false;
  return def;
}

}  // namespace

TEST(RigidDevice, AStackOf10Stands) {
  DeviceWorld d;
  lay_ground(d.world);
  for (int k = 0; k < 10; ++k)
    d.world.add_body(sleepless(body_def(cube, {0, half * (2.0f * static_cast<float>(k) + 1), 0})));
  run(d.world, dt, 2500);  // until it has stopped swaying
  std::vector<Pose> before;
  for (uint32_t n = 0; n < 10; ++n) before.push_back(d.world.pose(n));
  run(d.world, dt, 1500);
  EXPECT_NEAR(d.world.pose(9).position.y, 0.95f, 0.002f);
  for (uint32_t n = 0; n < 10; ++n)
    EXPECT_LT(length(d.world.pose(n).position - before[n].position), 0.0003f) << n;
}

TEST(RigidDevice, APyramidStands) {
  DeviceWorld d;
  lay_ground(d.world);
  for (int row = 0; row < 6; ++row) {
    for (int k = 0; k < 6 - row; ++k) {
      const float x = 2.1f * half * (static_cast<float>(k) + 0.5f * static_cast<float>(row));
      d.world.add_body(sleepless(body_def(cube, {x, half * (2.0f * static_cast<float>(row) + 1), 0})));
    }
  }
  run(d.world, dt, 500);
  EXPECT_NEAR(d.world.pose(20).position.y, half * 11, 0.002f);
  for (uint32_t n = 0; n < 21; ++n) EXPECT_LT(length(d.world.velocity(n)), 0.001f) << n;
}

// Bullet's solver needs shorter steps for this.
TEST(RigidDevice, ALightPlateBearsAHeavyLoad) {
  DeviceWorld d({.iterations = 20, .on_device = true});
  lay_ground(d.world);
  d.world.add_body(sleepless(body_def(box_part({0.2f, 0.02f, 0.2f}), {0, 0.02f, 0}, 100)));
  const uint32_t load =
      d.world.add_body(sleepless(body_def(box_part({0.1f, 0.1f, 0.1f}), {0, 0.14f, 0}, 24000)));
  ASSERT_NEAR(d.world.mass(0).inverse_mass / d.world.mass(load).inverse_mass, 300, 1);
  run(d.world, dt, 1000);
  EXPECT_NEAR(d.world.pose(load).position.y, 0.14f, 0.004f);
  EXPECT_LT(length(d.world.velocity(load)), 0.001f);
}

TEST(RigidDevice, SameBitsWithAnyNumberOfThreads) {
  const tests::ManyThreads many;
  std::vector<uint64_t> hashes;
  for (const int threads : {1, 8, 8}) {
    DeviceWorld d({.on_device = true}, threads);
    lay_ground(d.world);
    drop_jumble(d.world, 300);
    run(d.world, dt, 100);
    hashes.push_back(hash_of(d.world));
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_EQ(hashes[1], hashes[2]);
}

TEST(RigidDevice, ARestoredWorldContinuesWithTheSameBits) {
  DeviceWorld d;
  lay_ground(d.world);
  drop_jumble(d.world, 60);
  run(d.world, dt, 100);
  const RigidWorld::SnapshotPtr saved = RigidWorld::make_snapshot();
  d.world.save(*saved);
  run(d.world, dt, 50);
  const uint64_t hash = hash_of(d.world);
  d.world.restore(*saved);
  run(d.world, dt, 50);
  EXPECT_EQ(hash_of(d.world), hash);
}

TEST(RigidDevice, StepsThatAreTakenBackAreTakenAgainWithTheSameBits) {
  DeviceWorld d;
  lay_ground(d.world);
  drop_jumble(d.world, 60);
  run(d.world, dt, 100);
  const size_t touching = d.world.touches().size();
  ASSERT_GT(touching, 20u);
  const RigidWorld::SnapshotPtr kept = RigidWorld::make_snapshot();
  uint64_t hash = 0;
  for (const bool again : {false, true}) {
    d.world.save_bodies(*kept);
    d.world.keep_contacts(*kept);
    run(d.world, dt, 20);
    if (again) {
      EXPECT_EQ(hash_of(d.world), hash);
    }
    hash = hash_of(d.world);
    d.world.restore(*kept);
    EXPECT_EQ(d.world.touches().size(), touching);
  }
}

// A second solve is left out where no push comes, and the bits are those with it.
TEST(RigidDevice, APushOfNothingChangesNoBits) {
  uint64_t hashes[2];
  for (const bool pushed : {false, true}) {
    DeviceWorld d;
    lay_ground(d.world);
    drop_jumble(d.world, 60);
    // So far away that it touches none of them.
    const uint32_t far = d.world.add_body(body_def(cube, {50, 1, 0}));
    std::vector<RigidImpulse> impulses(far + 1, RigidImpulse{{0, 0, 0}, {0, 0, 0}});
    if (pushed) impulses[far].linear = {0.001f, 0, 0};
    for (int k = 0; k < 100; ++k) d.world.step(dt, impulses);
    EXPECT_EQ(d.world.velocity(far).x > 0, pushed);
    d.world.remove({true, far});
    hashes[pushed] = hash_of(d.world);
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(RigidDevice, ABodyThatIsRemovedLeavesTheOthersAtRest) {
  DeviceWorld d;
  lay_ground(d.world);
  for (int k = 0; k < 5; ++k)
    d.world.add_body(body_def(cube, {0, half * (2.0f * static_cast<float>(k) + 1), 0}));
  const uint32_t aside = d.world.add_body(body_def(cube, {1, half, 0}));
  run(d.world, dt, 300);
  d.world.remove({true, aside});
  run(d.world, dt, 1);
  for (uint32_t n = 0; n < 5; ++n) EXPECT_LT(length(d.world.velocity(n)), 0.001f) << n;
}

TEST(RigidDevice, RefusesWhatItHasNot) {
  DeviceWorld d;
  using tests::expect_error;
  expect_error(ErrorCode::invalid_argument, "no cylinders", [&] {
    d.world.add_body(body_def(round_part(Kind::cylinder, 0.1f, 0.1f), {0, 1, 0}));
  });
  EXPECT_EQ(d.world.body_count(), 0u);
  d.world.add_body(body_def(cube, {0, 1, 0}));
  expect_error(ErrorCode::invalid_argument, "no joints",
               [&] { d.world.add_joint({.a = 0, .kind = BallJoint{}}); });
}

}  // namespace meniscus::collision
