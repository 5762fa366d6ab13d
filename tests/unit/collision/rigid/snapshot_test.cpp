// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A restored world goes on as the first one did, to the bit; and so does a second one that was built alike.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/unit/collision/rigid/solvers.h"

namespace meniscus::collision {

namespace {

constexpr float dt = 0.004f;

RigidPart at(RigidPart part, Vec3 position, Quat turn = no_turn) {
  part.pose = {position, turn};
  return part;
}

RigidPart hull_part(Noise& noise, float size) {
  std::vector<Vec3> points;
  for (int i = 0; i < 40; ++i) points.push_back(noise.in_cube(size));
  return mesh_part(Kind::hull, hull_mesh(points));
}

/// The device has no cylinders.
RigidPart cylinder_part(Solver solver, float radius, float half_height) {
  if (solver == Solver::bullet) return round_part(Kind::cylinder, radius, half_height);
  std::vector<Vec3> points;
  for (int i = 0; i < 24; ++i) {
    const Vec3 rim = rotate(about({0, 1, 0}, 0.523598776f * static_cast<float>(i / 2)), {radius, 0, 0});
    points.push_back(rim + Vec3{0, i % 2 ? half_height : -half_height, 0});
  }
  return mesh_part(Kind::hull, hull_mesh(points));
}

/// Bodies of all kinds, `kind` from 0 to 6.
std::vector<RigidPart> body_parts(Solver solver, int kind, Noise& noise) {
  const float s = 0.05f + 0.05f * noise.next();
  switch (kind) {
    case 0:
      return {box_part({s, 0.7f * s, 0.5f * s})};
    case 1:
      return {round_part(Kind::sphere, s)};
    case 2:
      return {round_part(Kind::capsule, 0.6f * s, s)};
    case 3:
      return {cylinder_part(solver, s, 0.5f * s)};
    case 4:
      return {hull_part(noise, s)};
    case 5:  // a hammer
      return {at(box_part({1.5f * s, 0.2f * s, 0.2f * s}), {0, 0, 0}),
              at(cylinder_part(solver, 0.4f * s, 0.6f * s), {1.2f * s, 0, 0})};
    default:  // a dumb-bell
      return {at(round_part(Kind::sphere, 0.7f * s), {0, s, 0}),
              at(round_part(Kind::capsule, 0.2f * s, s), {0, 0, 0}),
              at(box_part({0.5f * s, 0.5f * s, 0.5f * s}), {0, -s, 0})};
  }
}

TriangleMesh bowl() {
  TriangleMesh mesh;
  const int n = 12;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      const float x = 0.2f * static_cast<float>(i) - 1.2f, z = 0.2f * static_cast<float>(j) - 1.2f;
      mesh.vertices.push_back({x, 0.4f * (x * x + z * z), z});
    }
  }
  for (uint32_t i = 0; i < n; ++i) {
    for (uint32_t j = 0; j < n; ++j) {
      const uint32_t a = i * (n + 1) + j, b = a + 1, c = a + n + 1, d = c + 1;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({b, d, c});
    }
  }
  return mesh;
}

void add_joints(RigidWorld& world, uint32_t pusher) {
  const float inf = std::numeric_limits<float>::infinity();
  const auto join = [&](uint32_t a, uint32_t b, JointKind kind) {
    RigidJointDef def;
    def.a = a;
    def.b = b;
    def.frame = {world.centre_of_mass(a), about({0.6f, 0, 0.8f}, 0.5f)};
    def.kind = kind;
    world.add_joint(def);
  };
  join(0, 1, HingeJoint{.lower = -1, .upper = 1, .motor_speed = 2, .motor_torque = 0.1f});
  join(2, 3, HingeJoint{.motor_speed = -3, .motor_torque = 0.2f});
  join(4, 5, SpringJoint{{300, 200, inf}, {1, 1, 0}, {2, inf, 1}, {0.01f, 0, 0.01f}});
  join(6, 7, SliderJoint{.lower = -0.1f, .upper = 0.2f, .motor_speed = 0.5f, .motor_force = 5});
  join(8, 9, BallJoint{});
  join(10, 11, FixedJoint{});
  join(12, pbd::no_index, SpringJoint{{50, 50, 50}, {1, 1, 1}, {}, {}});
  join(13, pusher, BallJoint{});
}

/// 60 bodies over a bowl in a plane, and a mill that stirs them.
std::unique_ptr<SolverWorld> make_pile(Solver solver) {
  auto world = std::make_unique<SolverWorld>(solver, RigidWorldDef{.substeps = 2});
  world->add_fixed(fixed_solid(mesh_part(Kind::mesh, bowl())));
  world->add_fixed(fixed_solid(plane_part({0, 1, 0}, -0.05f)));
  RigidPart field{.kind = Kind::height_field};
  field.heights = {5, 5, 0.3f, std::vector<float>(25, 0.2f)};
  field.heights.heights[12] = 0.4f;
  world->add_fixed(fixed_solid(field, {{1, 0, 0}, no_turn}));
  Noise noise(7);
  for (int i = 0; i < 60; ++i) {
    const Vec3 place{0.35f * static_cast<float>(i % 4) - 0.5f, 0.5f + 0.12f * static_cast<float>(i / 4),
                     0.3f * static_cast<float>(i / 4 % 4) - 0.45f};
    RigidBodyDef def =
        body_def(body_parts(solver, i % 7, noise),
                 {place + noise.in_cube(0.05f), about(normalized_or(noise.in_cube(1), {1, 0, 0}), 1)});
    def.velocity = noise.in_cube(2);
    def.solid.restitution = i % 5 == 0 ? 0.6f : 0;
    def.solid.friction = 0.1f * static_cast<float>(i % 9);
    def.linear_damping = i % 3 == 0 ? 0.1f : 0;
    world->add_body(def);
  }
  RigidBodyDef mill = kinematic_def(
      {at(box_part({0.8f, 0.05f, 0.02f}), {0, 0, 0}), at(box_part({0.02f, 0.05f, 0.8f}), {0, 0, 0})},
      {{0, 0.25f, 0}, no_turn});
  for (int i = 0; i <= 8; ++i) {
    mill.keyframes.push_back({0.25f * static_cast<float>(i),
                              {{0, 0.25f, 0}, about({0, 1, 0}, 0.785398163f * static_cast<float>(i))}});
  }
  mill.loop = true;
  const uint32_t pusher = world->add_body(mill);
  if (solver == Solver::bullet) add_joints(*world, pusher);
  return world;
}

/// A push that comes and goes.
std::vector<RigidImpulse> pushes(const RigidWorld& world, int step) {
  std::vector<RigidImpulse> impulses(world.body_slots(), {{0, 0, 0}, {0, 0, 0}});
  if (step / 20 % 2 == 0) return impulses;
  for (uint32_t i = 0; i < impulses.size(); i += 3) {
    impulses[i] = {{0.001f * static_cast<float>(step % 7), 0.002f, 0}, {0, 0.0001f, 0}};
  }
  return impulses;
}

void step(RigidWorld& world, int number) {
  if (number % 50 == 10) world.apply_force(17, {0, 3, 0}, world.centre_of_mass(17) + Vec3{0.01f, 0, 0});
  world.step(dt, pushes(world, number));
  if (number % 4 == 3) world.end_step();
}

std::vector<uint64_t> run_on(RigidWorld& world, int from, int steps) {
  std::vector<uint64_t> hashes;
  for (int i = 0; i < steps; ++i) {
    step(world, from + i);
    hashes.push_back(hash_of(world));
  }
  return hashes;
}

bool equal(const std::vector<RigidContact>& a, const std::vector<RigidContact>& b) {
  return std::ranges::equal(a, b, [](const RigidContact& p, const RigidContact& q) {
    return p.a.number == q.a.number && p.b.number == q.b.number && p.b.is_body == q.b.is_body &&
           p.point == q.point && p.normal == q.normal && p.distance == q.distance && p.impulse == q.impulse;
  });
}

}  // namespace

class RigidDeterminismTest : public OnSolver {};
MENISCUS_WITH_EACH_SOLVER(RigidDeterminismTest);

TEST_P(RigidDeterminismTest, TheSameCallsGiveTheSameBits) {
  const auto a = make_pile(GetParam()), b = make_pile(GetParam());
  EXPECT_EQ(run_on(*a, 0, 250), run_on(*b, 0, 250));
}

class RigidSnapshotTest : public OnSolver {};
MENISCUS_WITH_EACH_SOLVER(RigidSnapshotTest);

TEST_P(RigidSnapshotTest, SavingChangesNothing) {
  const auto a = make_pile(GetParam()), b = make_pile(GetParam());
  const auto snapshot = RigidWorld::make_snapshot();
  for (int i = 0; i < 200; ++i) {
    a->save(*snapshot);
    step(*a, i);
    step(*b, i);
    ASSERT_EQ(hash_of(*a), hash_of(*b)) << "step " << i;
  }
}

class RigidSnapshotAt : public testing::TestWithParam<std::tuple<Solver, int>> {};

TEST_P(RigidSnapshotAt, GoesOnAsBefore) {
  const auto [solver, steps] = GetParam();
  const auto world = make_pile(solver);
  run_on(*world, 0, steps);
  const auto snapshot = RigidWorld::make_snapshot();
  world->save(*snapshot);
  const uint64_t saved = hash_of(*world);
  const auto contacts = world->contacts();
  const double time = world->time();
  const auto first = run_on(*world, steps, 120);
  for (int again = 0; again < 2; ++again) {
    world->restore(*snapshot);
    EXPECT_EQ(hash_of(*world), saved);
    EXPECT_EQ(world->time(), time);
    EXPECT_TRUE(equal(world->contacts(), contacts));
    const auto second = run_on(*world, steps, 120);
    for (size_t i = 0; i < first.size(); ++i) ASSERT_EQ(first[i], second[i]) << "step " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Steps, RigidSnapshotAt,
                         testing::Combine(testing::Values(Solver::bullet),
                                          testing::Values(0, 1, 37, 80, 111, 150, 200, 301, 500)));
INSTANTIATE_TEST_SUITE_P(OnDevice, RigidSnapshotAt,
                         testing::Combine(testing::Values(Solver::device), testing::Values(1, 80, 200)));

TEST_P(RigidSnapshotTest, EachStepCanBeTakenBack) {
  const auto a = make_pile(GetParam()), b = make_pile(GetParam());
  const auto snapshot = RigidWorld::make_snapshot();
  for (int i = 0; i < 150; ++i) {
    a->save(*snapshot);
    step(*a, i);
    a->restore(*snapshot);
    step(*a, i);
    step(*b, i);
    ASSERT_EQ(hash_of(*a), hash_of(*b)) << "step " << i;
  }
}

// Bullet gives back the manifolds of what no longer lies together.
TEST_P(RigidSnapshotTest, WhatWasPutElsewhereBeforeHasNoContactsInIt) {
  const auto a = make_pile(GetParam()), b = make_pile(GetParam());
  const auto snapshot = RigidWorld::make_snapshot();
  for (int i = 0; i < 200; ++i) {
    for (RigidWorld* world : {a.get(), b.get()}) {
      if (i % 20 != 19) continue;
      for (uint32_t body = 14; body < 40; body += 2)
        world->set_pose(body, {{0.1f * static_cast<float>(body) - 3, 2, 0}, no_turn});
    }
    a->save(*snapshot);
    step(*a, i);
    a->restore(*snapshot);
    step(*a, i);
    step(*b, i);
    ASSERT_EQ(hash_of(*a), hash_of(*b)) << "step " << i;
  }
}

TEST_P(RigidSnapshotTest, HoldsWhoSleeps) {
  SolverWorld world(GetParam());
  world.add_fixed(fixed_solid(plane_part()));
  for (int i = 0; i < 5; ++i) {
    world.add_body(
        body_def(box_part({0.1f, 0.1f, 0.1f}), {0, 0.1f + 0.2f * static_cast<float>(i), 0.001f * i}));
  }
  const uint32_t mover =
      world.add_body(kinematic_def({box_part({0.1f, 0.1f, 0.1f})}, {{-2, 0.1f, 0}, no_turn}));
  const auto awake = RigidWorld::make_snapshot(), asleep = RigidWorld::make_snapshot();
  run(world, dt, 300);
  world.save(*awake);
  ASSERT_TRUE(world.awake(0));
  run(world, dt, 600);
  ASSERT_FALSE(world.awake(0));
  world.save(*asleep);
  const auto goes_on = [&] {
    world.move(mover, {{1, 0.1f, 0}, no_turn}, 1);
    std::vector<uint64_t> hashes;
    for (int i = 0; i < 400; ++i) {
      world.step(dt, {});
      hashes.push_back(hash_of(world));
    }
    EXPECT_LT(world.pose(4).position.y, 0.8f);  // it fell
    return hashes;
  };
  const auto first = goes_on();
  world.restore(*asleep);
  EXPECT_FALSE(world.awake(0));
  EXPECT_EQ(goes_on(), first);
  world.restore(*awake);
  EXPECT_TRUE(world.awake(0));
  run(world, dt, 600);
  EXPECT_EQ(goes_on(), first);
}

}  // namespace meniscus::collision
