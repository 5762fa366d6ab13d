// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of joints between rigid bodies.
#include <gtest/gtest.h>

#include <limits>

#include "tests/unit/collision/rigid/scene.h"

namespace meniscus::collision {

namespace {

constexpr float dt = 0.002f, pi = 3.14159265f;

/// Two cubes side by side without gravity: 0 is heavy.
struct TwoCubes {
  RigidWorld world;
  uint32_t a, b;

  explicit TwoCubes(Vec3 gravity = {0, 0, 0})
      : world({.gravity = gravity}),
        a(world.add_body(body_def(box_part({0.1f, 0.1f, 0.1f}), {0, 0, 0}, 1e8))),
        b(world.add_body(body_def(box_part({0.1f, 0.1f, 0.1f}), {0.3f, 0, 0}))) {}

  uint32_t join(JointKind kind, Pose frame = {}) {
    RigidJointDef def;
    def.a = a;
    def.b = b;
    def.frame = frame;
    def.kind = kind;
    return world.add_joint(def);
  }
};

RigidJointDef to_world_joint(uint32_t body, JointKind kind, const Pose& frame) {
  RigidJointDef def;
  def.a = body;
  def.frame = frame;
  def.kind = kind;
  return def;
}

/// The turn of b about y.
float turn_about_y(const RigidWorld& world, uint32_t body) {
  const Vec3 x = rotate(world.pose(body).rotation, {1, 0, 0});
  return std::atan2(-x.z, x.x);
}

}  // namespace

TEST(RigidJoint, AHingesMotorTurnsBAboutA) {
  TwoCubes cubes;
  const uint32_t joint = cubes.join(HingeJoint{.motor_speed = 1.5f, .motor_torque = 100});
  EXPECT_NEAR(cubes.world.hinge_angle(joint), 0, 1e-6f);
  run(cubes.world, dt, 500);
  EXPECT_NEAR(turn_about_y(cubes.world, cubes.b), 1.5f, 0.02f);
  EXPECT_NEAR(cubes.world.hinge_angle(joint), 1.5f, 0.02f);
  EXPECT_NEAR(length(cubes.world.centre_of_mass(cubes.b)), 0.3f, 1e-3f);
  EXPECT_LT(std::fabs(cubes.world.pose(cubes.b).position.y), 1e-4f);
}

TEST(RigidJoint, AHingesMotorGivesNoMoreThanItsTorque) {
  for (const float step : {0.004f, 0.001f}) {
    RigidWorld world({.gravity = {0, 0, 0}});
    const uint32_t wheel = world.add_body(body_def(round_part(Kind::cylinder, 0.2f, 0.05f), {0, 0, 0}));
    // The world is b, so the body turns against the motor's sense.
    world.add_joint(to_world_joint(wheel, HingeJoint{.motor_speed = -1e3f, .motor_torque = 0.5f}, {}));
    run(world, step, static_cast<int>(std::lround(0.4f / step)));
    const float rate = 0.5f * world.mass(wheel).inverse_inertia.y * 0.4f;
    EXPECT_NEAR(world.angular_velocity(wheel).y, rate, 0.01f * rate);
  }
}

TEST(RigidJoint, AHingeStopsAtItsLimits) {
  for (const float sense : {1.0f, -1.0f}) {
    TwoCubes cubes;
    const uint32_t joint =
        cubes.join(HingeJoint{.lower = -0.5f, .upper = 0.8f, .motor_speed = 2 * sense, .motor_torque = 1});
    run(cubes.world, dt, 1000);
    EXPECT_NEAR(cubes.world.hinge_angle(joint), sense > 0 ? 0.8f : -0.5f, 0.01f);
    EXPECT_NEAR(turn_about_y(cubes.world, cubes.b), sense > 0 ? 0.8f : -0.5f, 0.01f);
  }
}

TEST(RigidJoint, ASliderRunsAlongYAndStops) {
  TwoCubes cubes;
  const Pose frame{{0, 0, 0}, about({1, 0, 0}, 0.5f)};
  cubes.join(SliderJoint{.lower = -0.2f, .upper = 0.3f, .motor_speed = 0.4f, .motor_force = 100}, frame);
  const Vec3 axis = rotate(frame.rotation, {0, 1, 0}), start{0.3f, 0, 0};
  run(cubes.world, dt, 250);
  Vec3 way = cubes.world.pose(cubes.b).position - start;
  EXPECT_NEAR(dot(way, axis), 0.2f, 0.01f);
  EXPECT_LT(length(way - dot(way, axis) * axis), 1e-3f);
  run(cubes.world, dt, 500);
  way = cubes.world.pose(cubes.b).position - start;
  EXPECT_NEAR(dot(way, axis), 0.3f, 0.005f);
  EXPECT_LT(length(way - dot(way, axis) * axis), 1e-3f);
}

TEST(RigidJoint, ASlidersMotorGivesNoMoreThanItsForce) {
  for (const float step : {0.004f, 0.001f}) {
    RigidWorld world({.gravity = {0, 0, 0}});
    const uint32_t box = world.add_body(body_def(box_part({0.1f, 0.1f, 0.1f}), {0, 0, 0}));
    world.add_joint(to_world_joint(box, SliderJoint{.motor_speed = -1e3f, .motor_force = 4}, {}));
    run(world, step, static_cast<int>(std::lround(0.4f / step)));
    EXPECT_NEAR(world.velocity(box).y, 4 / 8.0f * 0.4f, 0.002f);
  }
}

TEST(RigidJoint, ABallHoldsAPendulum) {
  RigidWorld world({});
  const uint32_t bob = world.add_body(body_def(round_part(Kind::sphere, 0.05f), {0.1f, -1, 0}));
  world.add_joint(to_world_joint(bob, BallJoint{}, {}));
  const float length_squared = 1.01f, inertia = 0.4f * 0.05f * 0.05f + length_squared;
  const float period = 2 * pi * std::sqrt(inertia / (9.81f * std::sqrt(length_squared))) * 1.0006f;
  int crossings = 0;
  float last = 1, time = 0;
  for (int i = 0; crossings < 5; ++i) {
    world.step(0.001f, {});
    const float x = world.pose(bob).position.x;
    if ((x > 0) != (last > 0) && ++crossings == 1) time = -0.001f * static_cast<float>(i);
    if (crossings == 5) time += 0.001f * static_cast<float>(i);
    last = x;
    ASSERT_NEAR(length(world.pose(bob).position), std::sqrt(length_squared), 1e-3f);
    ASSERT_LT(i, 10000);
  }
  EXPECT_NEAR(time, 2 * period, 0.01f * period);
}

TEST(RigidJoint, AFixedJointCarriesACantilever) {
  for (const double density : {1e-12, 1e3, 1e15}) {
    RigidWorld world({.iterations = 50});
    const uint32_t beam = world.add_body(body_def(box_part({0.2f, 0.02f, 0.02f}), {0.2f, 0, 0}, density));
    world.add_joint(to_world_joint(beam, FixedJoint{}, {}));
    run(world, dt, 1000);
    EXPECT_LT(length(world.pose(beam).position - Vec3{0.2f, 0, 0}), 0.002f) << density;
  }
}

TEST(RigidJoint, SpringsSwingWithTheirPeriods) {
  const float inf = std::numeric_limits<float>::infinity();
  struct Case {
    SpringJoint spring;
    Vec3 push;     // N·s
    Vec3 turn;     // N·m·s
    float period;  // s
  };
  RigidWorld probe({});
  const RigidBodyDef cube = body_def(box_part({0.1f, 0.1f, 0.1f}), {0, 0, 0});
  const float inverse_inertia = probe.mass(probe.add_body(cube)).inverse_inertia.x;
  for (const Case& c :
       {Case{{{200, inf, inf}, {}, {inf, inf, inf}, {}}, {1, 0, 0}, {0, 0, 0}, std::sqrt(8 / 200.0f)},
        Case{{{inf, 400, inf}, {}, {inf, inf, inf}, {}}, {0, 1, 0}, {0, 0, 0}, std::sqrt(8 / 400.0f)},
        Case{{{inf, inf, inf}, {}, {inf, inf, 3}, {}},
             {0, 0, 0},
             {0, 0, 0.02f},
             1 / std::sqrt(3 * inverse_inertia)}}) {
    RigidWorld world({.gravity = {0, 0, 0}});
    const uint32_t box = world.add_body(cube);
    world.add_joint(to_world_joint(box, c.spring, {}));
    world.step(0.0005f, std::vector<RigidImpulse>{{c.push, c.turn}});
    const auto speed = [&] {
      return dot(world.velocity(box), c.push) + dot(world.angular_velocity(box), c.turn);
    };
    int crossings = 0, steps = 0;
    for (float last = speed(); crossings < 4 && steps < 20000; ++steps) {
      world.step(0.0005f, {});
      crossings += (speed() > 0) != (last > 0);
      last = speed();
    }
    EXPECT_NEAR(0.0005f * static_cast<float>(steps), 1.75f * 2 * pi * c.period, 0.02f * 2 * pi * c.period);
  }
}

TEST(RigidJoint, DampedSpringsSettleUnderTheLoad) {
  RigidWorld world({});
  const uint32_t box = world.add_body(body_def(box_part({0.1f, 0.1f, 0.1f}), {0, 0, 0}));
  const float inf = std::numeric_limits<float>::infinity();
  world.add_joint(to_world_joint(box, SpringJoint{{inf, 800, inf}, {0, 60, 0}, {inf, inf, inf}, {}}, {}));
  run(world, dt, 1000);
  EXPECT_NEAR(world.pose(box).position.y, -8 * 9.81f / 800, 0.002f);
  EXPECT_LT(length(world.velocity(box)), 1e-3f);
}

TEST(RigidJoint, DampedSpringsBearWhatParticlesPushWith) {
  RigidWorld world({.gravity = {0, 0, 0}});
  const uint32_t box = world.add_body(body_def(box_part({0.1f, 0.1f, 0.1f}), {0, 0, 0}));
  const float inf = std::numeric_limits<float>::infinity();
  world.add_joint(to_world_joint(box, SpringJoint{{inf, 800, inf}, {0, 600, 0}, {inf, inf, inf}, {}}, {}));
  std::vector<RigidImpulse> impulses(world.body_slots());
  impulses[box] = {{0, -80 * dt, 0}, {0, 0, 0}};
  for (int i = 0; i < 2000; ++i) world.step(dt, impulses);
  EXPECT_NEAR(world.pose(box).position.y, -80.0f / 800, 0.002f);
}

TEST(RigidJoint, JoinedBodiesCollideOnlyIfTold) {
  for (const bool collide : {false, true}) {
    RigidWorld world({.gravity = {0, 0, 0}});
    const uint32_t a = world.add_body(body_def(box_part({0.1f, 0.1f, 0.1f}), {0, 0, 0}));
    const uint32_t b = world.add_body(body_def(box_part({0.1f, 0.1f, 0.1f}), {0.15f, 0, 0}));
    RigidJointDef def;
    def.a = a;
    def.b = b;
    def.kind = SpringJoint{};
    def.bodies_collide = collide;
    const uint32_t joint = world.add_joint(def);
    run(world, dt, 300);
    EXPECT_EQ(world.touches().empty(), !collide);
    EXPECT_EQ(world.pose(b).position.x - world.pose(a).position.x > 0.19f, collide);
    world.remove_joint(joint);
    run(world, dt, 500);
    EXPECT_GT(world.pose(b).position.x - world.pose(a).position.x, 0.19f);  // they do now
  }
}

TEST(RigidJoint, AJointStopsAContactThatIsThere) {
  RigidWorld world({});
  world.add_fixed(fixed_solid(plane_part()));
  const uint32_t lower = world.add_body(body_def(box_part({0.1f, 0.1f, 0.1f}), {0, 0.1f, 0}));
  const uint32_t upper = world.add_body(body_def(box_part({0.1f, 0.1f, 0.1f}), {0, 0.3f, 0}));
  run(world, dt, 100);
  EXPECT_EQ(world.touches().size(), 2u);
  RigidJointDef def;
  def.a = lower;
  def.b = upper;
  def.kind = SpringJoint{};
  world.add_joint(def);
  run(world, dt, 300);
  EXPECT_NEAR(world.pose(upper).position.y, 0.1f, 0.01f);  // through the other one
}

TEST(RigidJoint, GoesWithItsBody) {
  TwoCubes cubes;
  const uint32_t joint = cubes.join(BallJoint{});
  EXPECT_TRUE(cubes.world.has_joint(joint));
  cubes.world.remove(RigidRef{true, cubes.b});
  EXPECT_FALSE(cubes.world.has_joint(joint));
  run(cubes.world, dt, 10);
}

}  // namespace meniscus::collision
