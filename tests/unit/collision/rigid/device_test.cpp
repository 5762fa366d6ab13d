// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Contacts among solids that a device solves, against the laws of mechanics.
#include <gtest/gtest.h>

#include <algorithm>

#include "pbd/device/cpu/cpu_device.h"
#include "tests/expect_error.h"
#include "tests/unit/collision/rigid/device_scene.h"

namespace meniscus::collision {

namespace {

constexpr float dt = 0.004f, half = 0.05f, pi = 3.14159265f;

const RigidPart cube = box_part({half, half, half});

void lay_ground(RigidWorld& world, float friction = 0.5f, float restitution = 0) {
  RigidSolid ground = fixed_solid(plane_part());
  ground.friction = friction;
  ground.restitution = restitution;
  world.add_fixed(ground);
}

RigidBodyDef sleepless(RigidBodyDef def) {
  def.can_sleep = false;
  return def;
}

RigidBodyDef with_surface(RigidBodyDef def, float friction, float restitution = 0) {
  def.solid.friction = friction;
  def.solid.restitution = restitution;
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

class RigidDeviceFriction : public testing::TestWithParam<float> {};

TEST_P(RigidDeviceFriction, HoldsUpToItsAngle) {
  for (const float side : {-1.0f, 1.0f}) {
    const float angle = std::atan(GetParam()) + side * pi / 180;
    for (const Vec3 axis : {Vec3{0, 0, 1}, Vec3{0.6f, 0, 0.8f}}) {
      DeviceWorld d;
      const Quat tilt = about(axis, angle);
      RigidSolid slope = fixed_solid(plane_part(rotate(tilt, {0, 1, 0})));
      slope.friction = GetParam();
      d.world.add_fixed(slope);
      const Pose start{rotate(tilt, {0, 0.05f, 0}), tilt};
      d.world.add_body(with_surface(body_def({box_part({0.1f, 0.05f, 0.1f})}, start), GetParam()));
      run(d.world, dt, 250);
      const float way = length(d.world.pose(0).position - start.position);
      // One degree more leaves an acceleration of g sin 1° / cos(limit), 0.17 m/s² or more.
      if (side < 0)
        EXPECT_LT(way, 0.002f) << "about " << axis.x << ' ' << axis.z;
      else
        EXPECT_GT(way, 0.06f) << "about " << axis.x << ' ' << axis.z;
    }
  }
}

TEST_P(RigidDeviceFriction, StopsAfterTheRightWay) {
  DeviceWorld d;
  lay_ground(d.world, GetParam());
  RigidBodyDef def = with_surface(body_def(box_part({0.1f, 0.02f, 0.1f}), {0, 0.02f, 0}), GetParam());
  def.velocity = {1.2f, 0, 1.6f};
  d.world.add_body(def);
  run(d.world, 0.001f, 2200);
  const float way = 2 * 2 / (2 * 9.81f * GetParam());
  EXPECT_NEAR(dot(d.world.pose(0).position, {0.6f, 0, 0.8f}), way, 0.01f * way);
}

INSTANTIATE_TEST_SUITE_P(Values, RigidDeviceFriction, testing::Values(0.1f, 0.3f, 0.5f, 0.7f));

TEST(RigidDevice, BouncesTheSameFromAnyHeight) {
  for (const RigidPart& part : {round_part(Kind::sphere, 0.1f), box_part({0.1f, 0.1f, 0.1f})}) {
    for (int k = 0; k < 20; ++k) {
      DeviceWorld d({.gravity = {0, 0, 0}, .on_device = true});
      lay_ground(d.world, 0.5f, 0.7f);
      RigidBodyDef def = body_def(part, {0, 0.15f + 0.0002f * static_cast<float>(k), 0});
      def.velocity = {0, -2, 0};
      d.world.add_body(with_surface(def, 0.5f, 0.7f));
      run(d.world, 0.001f, 60);
      EXPECT_NEAR(d.world.velocity(0).y, 1.4f, 0.03f) << k;
    }
  }
}

TEST(RigidDevice, CollisionsKeepMomentum) {
  DeviceWorld d({.gravity = {0, 0, 0}, .on_device = true});
  RigidBodyDef still = body_def(cube, {0.3f, 0.02f, 0.01f}, 500);
  RigidBodyDef fast = body_def({round_part(Kind::sphere, half)}, {{0, 0, 0}, no_turn}, 2000);
  fast.velocity = {2, 0, 0};
  fast.angular_velocity = {0, 3, 0};
  d.world.add_body(still);
  d.world.add_body(fast);
  const auto momentum = [&] {
    Vec3 sum{0, 0, 0};
    for (uint32_t n = 0; n < 2; ++n) sum += d.world.velocity(n) / d.world.mass(n).inverse_mass;
    return sum;
  };
  const Vec3 before = momentum();
  run(d.world, dt, 100);
  EXPECT_GT(d.world.velocity(0).x, 0.5f);
  EXPECT_LT(length(momentum() - before), 1e-5f * length(before));
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

TEST(RigidDevice, FiltersKeepSolidsApart) {
  DeviceWorld d;
  lay_ground(d.world);
  RigidBodyDef ghost = body_def(cube, {0, 1, 0});
  ghost.solid.filter = {2, 2};
  d.world.add_body(ghost);
  d.world.add_body(body_def(cube, {1, 1, 0}));
  run(d.world, dt, 250);
  EXPECT_LT(d.world.pose(0).position.y, -1);
  EXPECT_NEAR(d.world.pose(1).position.y, half, 0.001f);
}

TEST(RigidDevice, AKinematicBodyCarriesOthers) {
  DeviceWorld d;
  lay_ground(d.world);
  const uint32_t belt = d.world.add_body(kinematic_def({box_part({1, 0.1f, 1})}, {{0, 0.2f, 0}, no_turn}));
  const uint32_t box = d.world.add_body(body_def(cube, {0, 0.3f + half, 0}));
  run(d.world, dt, 25);
  d.world.move(belt, {{0.2f, 0.2f, 0}, no_turn}, 1);
  run(d.world, dt, 250);
  EXPECT_NEAR(d.world.pose(box).position.x, 0.2f, 0.005f);
}

TEST(RigidDevice, ContactsBearTheWeight) {
  DeviceWorld d;
  lay_ground(d.world);
  d.world.add_body(body_def(cube, {0, half, 0}));
  run(d.world, dt, 200);
  float impulse = 0;
  for (const RigidContact& c : d.world.contacts()) {
    EXPECT_NEAR(c.normal.y, 1, 1e-5f);
    impulse += c.impulse;
  }
  EXPECT_NEAR(impulse, 9.81f * dt, 0.01f * 9.81f * dt);  // of 1 kg
  EXPECT_EQ(d.world.touches().size(), 1u);
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
