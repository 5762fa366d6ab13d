// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of ray casts, overlaps and contacts of rigid bodies.
#include <gtest/gtest.h>

#include "tests/expect_error.h"
#include "tests/unit/collision/rigid/solvers.h"

namespace meniscus::collision {

namespace {

constexpr float dt = 0.004f;

RigidPart hill() {
  RigidPart part{.kind = Kind::height_field};
  part.heights = {5, 3, 0.5f, {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0}};
  return part;
}

bool has(const std::vector<RigidRef>& found, RigidRef wanted) {
  for (const RigidRef& r : found) {
    if (r.is_body == wanted.is_body && r.number == wanted.number) return true;
  }
  return false;
}

}  // namespace

TEST(RigidQuery, RaysMeetEveryShapeWhereItIs) {
  struct Case {
    RigidPart part;
    Vec3 from, to, point, normal;
  };
  const float c = std::sqrt(0.5f);
  const Case cases[] = {
      {box_part({0.5f, 0.3f, 0.2f}), {2, 0.1f, 0.1f}, {-2, 0.1f, 0.1f}, {0.5f, 0.1f, 0.1f}, {1, 0, 0}},
      {round_part(Kind::sphere, 0.5f), {0, 3, 0}, {0, -3, 0}, {0, 0.5f, 0}, {0, 1, 0}},
      {round_part(Kind::capsule, 0.2f, 0.5f), {0, 3, 0}, {0, -3, 0}, {0, 0.7f, 0}, {0, 1, 0}},
      {round_part(Kind::capsule, 0.2f, 0.5f), {0, 0.4f, 2}, {0, 0.4f, -2}, {0, 0.4f, 0.2f}, {0, 0, 1}},
      {round_part(Kind::cylinder, 0.2f, 0.5f), {0.1f, 3, 0}, {0.1f, -3, 0}, {0.1f, 0.5f, 0}, {0, 1, 0}},
      {mesh_part(Kind::hull, box_mesh({-1, -1, -1}, {1, 1, 1})),
       {0.3f, 0.2f, 4},
       {0.3f, 0.2f, -4},
       {0.3f, 0.2f, 1},
       {0, 0, 1}},
      {mesh_part(Kind::mesh, box_mesh({-1, -1, -1}, {1, 1, 1})),
       {0.3f, 0.2f, 4},
       {0.3f, 0.2f, -4},
       {0.3f, 0.2f, 1},
       {0, 0, 1}},
      {plane_part({0, c, c}, 0.5f), {0, 5, 0}, {0, -5, 0}, {0, c, 0}, {0, c, c}},
      {hill(), {0, 3, 0}, {0, -3, 0}, {0, 1, 0}, {0, 0, 0}},
      {hill(), {0.4f, 3, 0.05f}, {0.4f, -3, 0.05f}, {0.4f, 0.1f, 0.05f}, {0, 0, 0}},
      {hill(), {-0.25f, 3, 0.1f}, {-0.25f, -3, 0.1f}, {-0.25f, 0.5f, 0.1f}, {0, 0, 0}},
  };
  for (const Case& test : cases) {
    RigidWorld world({});
    const Pose pose{{0.7f, -0.3f, 2}, about({0.6f, 0, 0.8f}, 0.7f)};
    const uint32_t solid = world.add_fixed(fixed_solid(test.part, pose));
    RigidRayHit hit;
    ASSERT_TRUE(world.cast_ray(to_world(pose, test.from), to_world(pose, test.to), hit))
        << int(test.part.kind);
    EXPECT_FALSE(hit.solid.is_body);
    EXPECT_EQ(hit.solid.number, solid);
    EXPECT_LT(length(hit.point - to_world(pose, test.point)), 1e-4f) << int(test.part.kind);
    EXPECT_NEAR(length(hit.normal), 1, 1e-4f);
    if (length(test.normal) > 0) {
      EXPECT_LT(length(hit.normal - rotate(pose.rotation, test.normal)), 1e-4f) << int(test.part.kind);
    }
    EXPECT_NEAR(hit.fraction, length(test.point - test.from) / length(test.to - test.from), 1e-4f);
    EXPECT_FALSE(world.cast_ray(to_world(pose, test.from),
                                to_world(pose, test.from + 0.1f * (test.to - test.from)), hit));
  }
}

TEST(RigidQuery, TheNearestSolidIsHit) {
  RigidWorld world({});
  world.add_fixed(fixed_solid(plane_part()));
  const uint32_t near = world.add_body(body_def(box_part({0.1f, 0.1f, 0.1f}), {0, 2, 0}));
  world.add_body(body_def(box_part({0.1f, 0.1f, 0.1f}), {0, 1, 0}));
  RigidRayHit hit;
  ASSERT_TRUE(world.cast_ray({0, 5, 0}, {0, -5, 0}, hit));
  EXPECT_TRUE(hit.solid.is_body);
  EXPECT_EQ(hit.solid.number, near);
  EXPECT_NEAR(hit.point.y, 2.1f, 1e-4f);
  world.set_pose(near, {{3, 2, 0}, no_turn});
  world.step(dt, {});
  ASSERT_TRUE(world.cast_ray({3, 5, 0}, {3, -5, 0}, hit));
  EXPECT_EQ(hit.solid.number, near);
}

TEST(RigidQuery, OverlapsAreExact) {
  const float s = 0.5f;
  struct Case {
    RigidPart part;
    Vec3 outside, inside;  // where a ball of 0.1 m just does not touch, and just does
  };
  const float d = 0.1f / std::sqrt(3.0f), e = 0.01f;
  const Case cases[] = {
      // Over a corner the box around the ball would touch long before the ball does.
      {box_part({s, s, s}), {s + d + e, s + d + e, s + d + e}, {s + d - e, s + d - e, s + d - e}},
      {round_part(Kind::sphere, s), {0, s + 0.1f + e, 0}, {0, s + 0.1f - e, 0}},
      {round_part(Kind::capsule, 0.2f, s), {0.3f + e, 0.2f, 0}, {0.3f - e, 0.2f, 0}},
      {round_part(Kind::cylinder, s, 0.2f), {0, 0.3f + e, 0.1f}, {0, 0.3f - e, 0.1f}},
      {mesh_part(Kind::hull, box_mesh({-s, -s, -s}, {s, s, s})), {s + 0.1f + e, 0, 0}, {s + 0.1f - e, 0, 0}},
      {mesh_part(Kind::mesh, box_mesh({-s, -s, -s}, {s, s, s})), {s + 0.1f + e, 0, 0}, {s + 0.1f - e, 0, 0}},
      {mesh_part(Kind::mesh, box_mesh({-s, -s, -s}, {s, s, s})), {s + 0.1f + e, 0, 0}, {0, 0.1f, 0}},
      {plane_part(), {0, 0.1f + e, 0}, {3, -7, 0}},
      {hill(), {-0.5f, 0.1f + e + 0.07f, 0.5f}, {0, 0.3f, 0}},
  };
  for (const Case& c : cases) {
    RigidWorld world({});
    const Pose pose{{0.7f, -0.3f, 2}, about({0.6f, 0, 0.8f}, 0.7f)};
    RigidSolid solid = fixed_solid(c.part, pose);
    solid.filter = {2, 2};  // queries see all
    const RigidRef wanted{false, world.add_fixed(solid)};
    const auto ball_at = [&](Vec3 p) {
      return world.overlaps({to_world(pose, p), no_turn}, {0.1f, 0, 0}, true);
    };
    EXPECT_FALSE(has(ball_at(c.outside), wanted)) << int(c.part.kind);
    EXPECT_TRUE(has(ball_at(c.inside), wanted)) << int(c.part.kind);
  }
}

TEST(RigidQuery, ABoxOverlapsAsItIsTurned) {
  RigidWorld world({});
  const RigidRef box{true, world.add_body(body_def(box_part({0.1f, 0.1f, 0.1f}), {0, 0, 0}))};
  const Vec3 half{0.5f, 0.05f, 0.05f};
  EXPECT_TRUE(has(world.overlaps({{0.55f, 0, 0}, no_turn}, half, false), box));
  EXPECT_FALSE(has(world.overlaps({{0.55f, 0, 0}, about({0, 1, 0}, 1.5707963f)}, half, false), box));
  // Along the diagonal it reaches the cube, across it only its bounding box does.
  EXPECT_TRUE(has(world.overlaps({{0.42f, 0.42f, 0}, about({0, 0, 1}, 0.785398f)}, half, false), box));
  EXPECT_FALSE(has(world.overlaps({{0.3f, 0.3f, 0}, about({0, 0, 1}, -0.785398f)}, half, false), box));
  EXPECT_TRUE(world.overlaps({{5, 0, 0}, no_turn}, half, false).empty());
}

TEST(RigidQuery, OverlapsChangeNothing) {
  RigidWorld a({}), b({});
  for (RigidWorld* world : {&a, &b}) {
    world->add_fixed(fixed_solid(plane_part()));
    for (int i = 0; i < 30; ++i) {
      world->add_body(body_def(box_part({0.1f, 0.1f, 0.1f}), {0.15f * static_cast<float>(i % 3),
                                                              0.1f + 0.22f * static_cast<float>(i / 3), 0}));
    }
  }
  for (int i = 0; i < 200; ++i) {
    EXPECT_FALSE(a.overlaps({{0, 0.5f, 0}, no_turn}, {0.5f, 0.5f, 0.5f}, i % 2 == 0).empty());
    RigidRayHit hit;
    EXPECT_TRUE(a.cast_ray({0, 9, 0}, {0, -9, 0}, hit));
    a.step(dt, {});
    b.step(dt, {});
    ASSERT_EQ(hash_of(a), hash_of(b));
  }
}

class RigidQueryTest : public OnSolver {};
MENISCUS_WITH_EACH_SOLVER(RigidQueryTest);

TEST_P(RigidQueryTest, ContactsSayWhoPushesWhom) {
  SolverWorld world(GetParam());
  const uint32_t ground = world.add_fixed(fixed_solid(plane_part()));
  const uint32_t lower = world.add_body(body_def(box_part({0.2f, 0.2f, 0.2f}), {0, 0.2f, 0}));
  const uint32_t upper = world.add_body(body_def(box_part({0.1f, 0.1f, 0.1f}), {0, 0.5f, 0}));
  world.add_body(body_def(box_part({0.1f, 0.1f, 0.1f}), {5, 5, 0}));
  run(world, dt, 100);
  float on_ground = 0, on_lower = 0;
  for (const RigidContact& contact : world.contacts()) {
    ASSERT_TRUE(contact.a.is_body);
    ASSERT_EQ(contact.a.number, lower);
    if (contact.b.is_body) {
      EXPECT_EQ(contact.b.number, upper);
      EXPECT_LT(contact.normal.y, -0.999f);  // from the upper one to the lower one
      EXPECT_NEAR(contact.point.y, 0.4f, 0.002f);
      on_lower += contact.impulse;
    } else {
      EXPECT_EQ(contact.b.number, ground);
      EXPECT_GT(contact.normal.y, 0.999f);
      EXPECT_NEAR(contact.point.y, 0, 0.002f);
      on_ground += contact.impulse;
    }
  }
  EXPECT_NEAR(on_lower, 8 * 9.81f * dt, 0.02f * 8 * 9.81f * dt);
  EXPECT_NEAR(on_ground, 72 * 9.81f * dt, 0.02f * 72 * 9.81f * dt);
  const std::vector<RigidTouch> touches = world.touches();
  ASSERT_EQ(touches.size(), 2u);
  EXPECT_TRUE(touches[0].b.is_body);
  EXPECT_FALSE(touches[1].b.is_body);
}

// The large body has the smaller number, and is in no grid.
TEST_P(RigidQueryTest, ALargeBodyOnASmallSolidIsTheFirst) {
  SolverWorld world(GetParam());
  for (const float x : {-0.3f, 0.0f, 0.3f}) {
    const Pose at{{x, 0, x == 0 ? 0.2f : -0.2f}, no_turn};
    world.add_fixed(fixed_solid(box_part({0.02f, 0.02f, 0.02f}), at));
  }
  world.add_body(body_def(box_part({1, 0.05f, 1}), {0, 0.07f, 0}));
  run(world, dt, 50);
  ASSERT_FALSE(world.contacts().empty());
  for (const RigidContact& contact : world.contacts()) {
    EXPECT_TRUE(contact.a.is_body);
    EXPECT_FALSE(contact.b.is_body);
    EXPECT_GT(contact.normal.y, 0.999f);
    EXPECT_NEAR(contact.point.y, 0.02f, 0.002f);
    EXPECT_LT(std::fabs(contact.point.x), 0.33f);
  }
}

TEST(RigidQuery, AFlatHullIsAnError) {
  RigidWorld world({});
  TriangleMesh flat;
  flat.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.3f, 0.3f, 0}};
  tests::expect_error(ErrorCode::invalid_argument, "volume",
                      [&] { world.add_fixed(fixed_solid(mesh_part(Kind::hull, flat))); });
  RigidRayHit hit;
  EXPECT_FALSE(world.cast_ray({0.2f, 0.2f, 1}, {0.2f, 0.2f, -1}, hit));
}

TEST(RigidQuery, AHullOfManyPointsKeepsItsSize) {
  for (const float radius : {0.02f, 1.0f}) {
    RigidWorld world({.gravity = {0, 0, 0}});
    const uint32_t ball = world.add_body(body_def(mesh_part(Kind::hull, ball_mesh(radius, 4)), {0, 0, 0}));
    for (const Vec3 d : {Vec3{1, 0, 0}, Vec3{0.6f, 0.8f, 0}, Vec3{0.48f, -0.6f, 0.64f}}) {
      RigidRayHit hit;
      ASSERT_TRUE(world.cast_ray(3 * radius * d, {0, 0, 0}, hit));
      EXPECT_EQ(hit.solid.number, ball);
      EXPECT_NEAR(length(hit.point), radius, 0.02f * radius);
    }
  }
}

}  // namespace meniscus::collision
