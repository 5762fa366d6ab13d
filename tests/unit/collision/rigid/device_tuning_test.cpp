// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What the tuned constants of contacts on a device promise (collision/rigid_contact/tuning.h).
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "collision/rigid_contact/tuning.h"
#include "tests/unit/collision/rigid/device_scene.h"

namespace meniscus::collision {

namespace {

constexpr float dt = 0.004f;

RigidWorldDef weightless_def() {
  return {.gravity = {0, 0, 0}, .on_device = true};
}

}  // namespace

// Two small balls, at all places within a step where they may be.
TEST(RigidDeviceTuning, PartsThatCloseInByTheirReachMeet) {
  constexpr float radius = 0.01f, speed = rigid_contact_tuning::most_reach * radius / dt;
  for (int k = 0; k < 20; ++k) {
    DeviceWorld d(weightless_def());
    for (const float side : {-1.0f, 1.0f}) {
      RigidBodyDef def = body_def(round_part(Kind::sphere, radius),
                                  {side * (0.05f + 0.0001f * static_cast<float>(k)), 0, 0});
      def.velocity = {-side * speed, 0, 0};
      d.world.add_body(def);
    }
    run(d.world, dt, 60);
    EXPECT_LT(d.world.pose(0).position.x, -0.98f * radius) << k;
    EXPECT_LT(std::fabs(d.world.velocity(0).x), 0.1f * speed) << k;
  }
}

// They come apart with no more than this speed, and each keeps less than a twentieth of it.
TEST(RigidDeviceTuning, OverlapsGoAtTheirBound) {
  constexpr float half = 0.05f, overlap = 0.03f;
  DeviceWorld d(weightless_def());
  for (const float side : {-1.0f, 1.0f})
    d.world.add_body(body_def(box_part({half, half, half}), {side * (half - 0.5f * overlap), 0, 0}));
  const auto apart = [&] { return d.world.pose(1).position.x - d.world.pose(0).position.x - 2 * half; };
  const float bound = rigid_contact_tuning::push_rate * std::sqrt(3.0f) * half;
  float before = apart();
  ASSERT_NEAR(before, -overlap, 1e-6f);
  for (int i = 0; i < 100; ++i) {
    run(d.world, dt, 1);
    EXPECT_LE(apart() - before, 1.001f * bound * dt) << i;
    before = apart();
  }
  EXPECT_GT(before, 0);
  EXPECT_LT(length(d.world.velocity(0)), 0.05f * bound);
}

// Some are in the grid, and some are tested against all.
TEST(RigidDeviceTuning, PartsOfAllSizesFindOneAnother) {
  DeviceWorld d(weightless_def());
  Noise noise(11);
  std::vector<float> radii;
  for (int k = 0; k < 150; ++k) {
    radii.push_back(0.02f * std::pow(20.0f, noise.next()));
    d.world.add_body(body_def(round_part(Kind::sphere, radii.back()), noise.in_cube(1)));
  }
  std::vector<Vec3> at;
  for (uint32_t n = 0; n < radii.size(); ++n) at.push_back(d.world.pose(n).position);
  size_t expected = 0;
  for (size_t i = 0; i < at.size(); ++i)
    for (size_t j = 0; j < i; ++j) expected += length(at[i] - at[j]) < radii[i] + radii[j] - 1e-5f;
  run(d.world, 1e-6f, 1);
  ASSERT_GT(expected, 50u);
  EXPECT_EQ(d.world.touches().size(), expected);
}

// A plate on 100 balls has more contacts than colours.
TEST(RigidDeviceTuning, ABodyOfMoreContactsThanColoursRests) {
  constexpr float radius = 0.02f;
  DeviceWorld d;
  d.world.add_fixed(fixed_solid(plane_part()));
  for (int k = 0; k < 100; ++k) {
    RigidBodyDef ball =
        body_def(round_part(Kind::sphere, radius),
                 {0.06f * static_cast<float>(k % 10), radius, 0.06f * static_cast<float>(k / 10)});
    ball.can_sleep = false;
    d.world.add_body(ball);
  }
  RigidBodyDef plate = body_def(box_part({0.3f, 0.02f, 0.3f}), {0.27f, 2 * radius + 0.02f, 0.27f});
  plate.can_sleep = false;
  const uint32_t top = d.world.add_body(plate);
  run(d.world, dt, 500);
  EXPECT_NEAR(d.world.pose(top).position.y, 2 * radius + 0.02f, 0.002f);
  EXPECT_LT(length(d.world.velocity(top)), 0.002f);
}

}  // namespace meniscus::collision
