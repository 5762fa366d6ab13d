// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Contacts among solids, against the laws of mechanics, with each solver.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>

#include "tests/unit/collision/rigid/solvers.h"

namespace meniscus::collision {

namespace {

constexpr float dt = 0.004f, pi = 3.14159265f;

/// A box on a plane that is tilted about an axis in the ground: how far it is after a second.
float slide_on_slope(Solver solver, float friction, float angle, Vec3 axis) {
  SolverWorld world(solver);
  const Quat tilt = about(axis, angle);
  RigidSolid slope = fixed_solid(plane_part(rotate(tilt, {0, 1, 0})));
  slope.friction = friction;
  world.add_fixed(slope);
  RigidBodyDef def = body_def({box_part({0.1f, 0.05f, 0.1f})}, {rotate(tilt, {0, 0.05f, 0}), tilt});
  def.solid.friction = friction;
  const uint32_t box = world.add_body(def);
  run(world, dt, 250);
  return length(world.pose(box).position - rotate(tilt, {0, 0.05f, 0}));
}

}  // namespace

class RigidFriction : public testing::TestWithParam<std::tuple<Solver, float>> {
 protected:
  const Solver solver = std::get<0>(GetParam());
  const float friction = std::get<1>(GetParam());
};

TEST_P(RigidFriction, HoldsUpToItsAngle) {
  const float limit = std::atan(friction), degree = pi / 180;
  for (const Vec3 axis : {Vec3{0, 0, 1}, Vec3{1, 0, 0}, Vec3{0.6f, 0, 0.8f}}) {
    EXPECT_LT(slide_on_slope(solver, friction, limit - degree, axis), 0.002f)
        << "about " << axis.x << ' ' << axis.z;
    // One degree more leaves an acceleration of g sin 1° / cos(limit), 0.17 m/s² or more.
    EXPECT_GT(slide_on_slope(solver, friction, limit + degree, axis), 0.06f)
        << "about " << axis.x << ' ' << axis.z;
  }
}

TEST_P(RigidFriction, StopsAfterTheRightWay) {
  for (const Vec3 direction : {Vec3{1, 0, 0}, Vec3{0.6f, 0, 0.8f}}) {
    SolverWorld world(solver);
    RigidSolid ground = fixed_solid(plane_part());
    ground.friction = friction;
    world.add_fixed(ground);
    RigidBodyDef def = body_def(box_part({0.1f, 0.02f, 0.1f}), {0, 0.02f, 0});
    def.solid.friction = friction;
    def.velocity = 2.0f * direction;
    const uint32_t box = world.add_body(def);
    run(world, 0.001f, 2200);
    const float way = 2 * 2 / (2 * 9.81f * friction);
    EXPECT_NEAR(dot(world.pose(box).position, direction), way, 0.01f * way);
  }
}

INSTANTIATE_TEST_SUITE_P(Values, RigidFriction,
                         testing::Combine(testing::ValuesIn(solvers),
                                          testing::Values(0.1f, 0.3f, 0.5f, 0.7f)));

class RigidContactTest : public OnSolver {};
MENISCUS_WITH_EACH_SOLVER(RigidContactTest);

TEST_P(RigidContactTest, DifferentFrictionsMakeTheirGeometricMean) {
  SolverWorld world(GetParam());
  RigidSolid ground = fixed_solid(plane_part());
  ground.friction = 0.9f;
  world.add_fixed(ground);
  RigidBodyDef def = body_def(box_part({0.1f, 0.02f, 0.1f}), {0, 0.02f, 0});
  def.solid.friction = 0.4f;
  def.velocity = {2, 0, 0};
  const uint32_t box = world.add_body(def);
  run(world, 0.001f, 1000);
  const float way = 2 * 2 / (2 * 9.81f * 0.6f);
  EXPECT_NEAR(world.pose(box).position.x, way, 0.01f * way);
}

TEST_P(RigidContactTest, BouncesWithItsRestitution) {
  SolverWorld world(GetParam());
  RigidSolid ground = fixed_solid(plane_part());
  ground.restitution = 0.8f;
  world.add_fixed(ground);
  RigidBodyDef def = body_def(round_part(Kind::sphere, 0.1f), {0, 0.6f, 0});
  def.solid.restitution = 0.8f;
  const uint32_t ball = world.add_body(def);
  float top = 0;
  bool bounced = false;
  for (int i = 0; i < 700; ++i) {
    world.step(0.001f, {});
    bounced |= world.velocity(ball).y > 0;
    if (bounced) top = std::max(top, world.pose(ball).position.y - 0.1f);
  }
  EXPECT_NEAR(top, 0.8f * 0.8f * 0.5f, 0.02f);
}

// A step that ends in the air just before an impact must leave the bounce to the next one.
TEST_P(RigidContactTest, BouncesTheSameFromAnyHeight) {
  for (const RigidPart& part : {round_part(Kind::sphere, 0.1f), box_part({0.1f, 0.1f, 0.1f})}) {
    for (int k = 0; k < 40; ++k) {
      SolverWorld world(GetParam(), {.gravity = {0, 0, 0}});
      RigidSolid ground = fixed_solid(plane_part());
      ground.restitution = 0.7f;
      world.add_fixed(ground);
      RigidBodyDef def = body_def(part, {0, 0.15f + 0.0001f * static_cast<float>(k), 0});
      def.solid.restitution = 0.7f;
      def.velocity = {0, -2, 0};
      const uint32_t body = world.add_body(def);
      run(world, 0.001f, 60);
      EXPECT_NEAR(world.velocity(body).y, 1.4f, 0.03f) << k;
    }
  }
}

TEST_P(RigidContactTest, CollisionsKeepMomentum) {
  SolverWorld world(GetParam(), {.gravity = {0, 0, 0}});
  RigidBodyDef still = body_def(box_part({0.05f, 0.05f, 0.05f}), {0.3f, 0.02f, 0.01f}, 500);
  RigidBodyDef fast = body_def({round_part(Kind::sphere, 0.05f)}, {{0, 0, 0}, no_turn}, 2000);
  fast.velocity = {2, 0, 0};
  fast.angular_velocity = {0, 3, 0};
  world.add_body(still);
  world.add_body(fast);
  const auto momentum = [&] {
    Vec3 sum{0, 0, 0};
    for (uint32_t n = 0; n < 2; ++n) sum += world.velocity(n) / world.mass(n).inverse_mass;
    return sum;
  };
  const Vec3 before = momentum();
  run(world, dt, 100);
  EXPECT_GT(world.velocity(0).x, 0.5f);
  EXPECT_LT(length(momentum() - before), 1e-5f * length(before));
}

class RigidRest : public testing::TestWithParam<std::tuple<Solver, float>> {};

TEST_P(RigidRest, IsQuietAtAnySize) {
  const auto [solver, half] = GetParam();
  SolverWorld world(solver);
  world.add_fixed(fixed_solid(plane_part()));
  std::vector<RigidPart> parts{
      box_part({half, half, half}),
      mesh_part(Kind::hull, box_mesh({-half, -half, -half}, {half, half, half})),
  };
  if (solver == Solver::bullet) parts.push_back(round_part(Kind::cylinder, half, half));
  float x = 0;
  for (const RigidPart& part : parts) {
    RigidBodyDef def = body_def(part, {x += 4 * half, 1.2f * half, 0});
    def.can_sleep = false;
    world.add_body(def);
  }
  run(world, dt, 500);
  for (int i = 0; i < 100; ++i) {
    world.step(dt, {});
    for (uint32_t body = 0; body < parts.size(); ++body) {
      ASSERT_NEAR(world.pose(body).position.y, half, 0.01f * half) << body;
      ASSERT_LT(length(world.velocity(body)), 0.005f * std::sqrt(9.81f * half)) << body;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Halves, RigidRest,
                         testing::Combine(testing::ValuesIn(solvers),
                                          testing::Values(0.01f, 0.05f, 0.5f, 5.0f)));

class RigidWeight : public testing::TestWithParam<std::tuple<Solver, double>> {};

TEST_P(RigidWeight, OneBoxRestsOnAnother) {
  const auto [solver, density] = GetParam();
  SolverWorld world(solver);
  world.add_fixed(fixed_solid(plane_part()));
  const uint32_t below = world.add_body(body_def(box_part({0.5f, 0.5f, 0.5f}), {0, 0.5f, 0}, density));
  const uint32_t above = world.add_body(body_def(box_part({0.5f, 0.5f, 0.5f}), {0.1f, 1.52f, 0}, density));
  run(world, dt, 500);
  EXPECT_NEAR(world.pose(below).position.y, 0.5f, 0.005f);
  EXPECT_NEAR(world.pose(above).position.y, 1.5f, 0.01f);
  float borne = 0;
  for (const RigidContact& contact : world.contacts()) {
    if (contact.a.is_body && contact.b.is_body) borne += contact.impulse / dt;
  }
  EXPECT_NEAR(borne, 9.81 * density, 0.05 * 9.81 * density);
}

INSTANTIATE_TEST_SUITE_P(Densities, RigidWeight,
                         testing::Combine(testing::ValuesIn(solvers),
                                          testing::Values(1e-15, 1e-6, 1e3, 1e9, 1e13)));

TEST_P(RigidContactTest, CarriesAThousandTimesItsWeight) {
  SolverWorld world(GetParam(), {.iterations = 100});
  world.add_fixed(fixed_solid(plane_part()));
  const float half = 0.1f;
  std::vector<uint32_t> boxes;
  for (int i = 0; i < 4; ++i) {
    const float y = half * (2.02f * static_cast<float>(i) + 1.01f);
    RigidBodyDef def = body_def(box_part({half, half, half}), {0, y, 0}, 100 * std::pow(10.0, i));
    boxes.push_back(world.add_body(def));
  }
  for (int i = 0; i < 2000; ++i) {
    world.step(0.001f, {});
    for (const uint32_t box : boxes) ASSERT_LT(length(world.velocity(box)), 0.5f) << i;
  }
  float below = 0;
  for (const uint32_t box : boxes) {
    const float bottom = world.pose(box).position.y - half;
    EXPECT_LT(below - bottom, 0.01f * 2 * half) << box;
    EXPECT_NEAR(bottom, below, 0.01f * 2 * half) << box;
    below = bottom + 2 * half;
  }
}

TEST_P(RigidContactTest, FastSmallBallsDoNotPassThroughAThinWall) {
  SolverWorld world(GetParam(), {.gravity = {0, 0, 0}});
  world.add_fixed(fixed_solid(box_part({0.005f, 1, 1})));
  for (int i = 0; i < 20; ++i) {
    RigidBodyDef def = body_def(round_part(Kind::sphere, 0.01f),
                                {-1 - 0.013f * static_cast<float>(i), 0, 0.08f * static_cast<float>(i - 10)});
    def.velocity = {40, 0, 0};
    world.add_body(def);
  }
  run(world, dt, 50);
  for (uint32_t ball = 0; ball < 20; ++ball) EXPECT_LT(world.pose(ball).position.x, 0) << ball;
}

// Up to ten diameters of each in a step; contacts are looked for before velocities are known. The device
// reaches a quarter of a radius.
TEST(RigidContact, ManyFastSmallBodiesDoNotPassThroughOneAnother) {
  constexpr uint32_t pairs = 200;
  SolverWorld world(Solver::bullet, {.gravity = {0, 0, 0}});
  const auto add = [&](const RigidPart& part, float x, uint32_t n, float speed) {
    const Vec3 place{x, 0.1f * static_cast<float>(n / 20), 0.1f * static_cast<float>(n % 20)};
    RigidBodyDef def = body_def(part, place);
    def.velocity = {speed, 0, 0};
    return world.add_body(def);
  };
  for (uint32_t n = 0; n < pairs; ++n) {
    const float way = 0.5f + 0.0037f * static_cast<float>(n);
    const uint32_t shot = add(box_part({0.01f, 0.01f, 0.01f}), -way, n, 50);
    const uint32_t target = add(round_part(Kind::sphere, 0.01f), 0, n, 0);
    ASSERT_EQ(shot, 2 * n);
    ASSERT_EQ(target, 2 * n + 1);
  }
  run(world, dt, 25);
  for (uint32_t n = 0; n < pairs; ++n) {
    EXPECT_LT(world.pose(2 * n).position.x, world.pose(2 * n + 1).position.x) << n;
    EXPECT_GT(world.velocity(2 * n + 1).x, 5) << n;
  }
}

TEST_P(RigidContactTest, AFastBallBouncesToo) {
  SolverWorld world(GetParam(), {.gravity = {0, 0, 0}});
  RigidSolid wall = fixed_solid(box_part({0.1f, 1, 1}));
  wall.restitution = 1;
  world.add_fixed(wall);
  RigidBodyDef def = body_def(round_part(Kind::sphere, 0.02f), {-1, 0, 0});
  def.solid.restitution = 1;
  def.velocity = {20, 0, 0};
  const uint32_t ball = world.add_body(def);
  run(world, dt, 40);
  EXPECT_NEAR(world.velocity(ball).x, -20, 0.2f);
}

TEST_P(RigidContactTest, MasksCountBothWays) {
  struct Case {
    CollisionFilter ground, box;
    bool collides;
  };
  for (const Case& c : {Case{{1, 1}, {1, 1}, true}, Case{{1, 2}, {2, 1}, true}, Case{{1, 1}, {2, 1}, false},
                        Case{{1, 2}, {2, 2}, false}, Case{{1u << 31, ~0u}, {1, 1u << 31}, true}}) {
    SolverWorld world(GetParam());
    RigidSolid ground = fixed_solid(plane_part());
    ground.filter = c.ground;
    world.add_fixed(ground);
    RigidBodyDef def = body_def(box_part({0.1f, 0.1f, 0.1f}), {0, 0.1f, 0});
    def.solid.filter = c.box;
    const uint32_t box = world.add_body(def);
    run(world, dt, 100);
    EXPECT_EQ(world.pose(box).position.y > 0, c.collides);
  }
}

TEST_P(RigidContactTest, WhatFallsForEverDoesNotSlowTheRestDown) {
  SolverWorld world(GetParam());
  world.add_fixed(fixed_solid(mesh_part(Kind::mesh, box_mesh({-9e3f, -9e3f, -9e3f}, {9e3f, -8e3f, 9e3f}))));
  for (int i = 0; i < 300; ++i) {
    // All in one column, and all beyond the space that is swept.
    RigidBodyDef def = body_def(box_part({0.1f, 0.1f, 0.1f}), {0, -2e4f - static_cast<float>(i), 0});
    def.velocity = {0, -1e3f, 0};
    world.add_body(def);
  }
  run(world, 1, 200);
  EXPECT_TRUE(world.contacts().empty());
  EXPECT_LT(world.pose(7).position.y, -1e5f);
  run(world, 1e6f, 20);  // far beyond what a float can resolve
}

TEST_P(RigidContactTest, HasRoomForAnyNumber) {
  SolverWorld world(GetParam(), {.gravity = {0, 0, 0}});
  const uint32_t count = 1500;
  for (uint32_t i = 0; i < count; ++i) {
    world.add_body(body_def(box_part({0.1f, 0.1f, 0.1f}),
                            {0.199f * static_cast<float>(i % 40), 0.199f * static_cast<float>(i / 40), 0}));
    if (i == 200) run(world, dt, 1);  // pairs that must live through the growth
  }
  run(world, dt, 1);
  EXPECT_EQ(world.body_count(), count);
  EXPECT_GT(world.touches().size(), 2 * count - 200);
  for (uint32_t i = 0; i < count; ++i) world.remove(RigidRef{true, i});
  EXPECT_EQ(world.body_slots(), 0u);
  EXPECT_TRUE(world.contacts().empty());
}

}  // namespace meniscus::collision
