// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A driven body moves water, and water drives a body that can rotate.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/coupling/body_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float s = 0.05f, dt = 0.016f;
const Quat axis_along_z{0.70710678f, 0, 0, 0.70710678f};  // takes y to z

class PaddleTest : public OnDevice {
 protected:
  World world_{world_def(GetParam(), s)};
  FluidId water_ = world_.create_fluid({});

  void fill(Vec3 size, float depth) {
    world_.create_shape(tank({0, 0, 0}, size));
    world_.add_fluid(block(water_, {0, 0, 0}, {size.x, depth, size.z}));
  }

  JointId hinge(BodyId id, Vec3 at, const HingeJoint& kind) {
    JointDef def;
    def.a = id;
    def.frame = {at, axis_along_z};
    def.kind = kind;
    return world_.create_joint(def);
  }
};

// A plate goes through a trough at half a metre a second: the water goes along, and what it gained in
// momentum is what the plate and the end walls have given it.
TEST_P(PaddleTest, AKinematicPaddlePushesWaterAndFeelsIt) {
  const BodyId plate = world_.create_body(kinematic(BoxGeometry{{0.03f, 0.3f, 0.18f}}, {0.4f, 0.32f, 0.2f}));
  fill({1.6f, 1, 0.4f}, 0.4f);
  run(world_, 20, dt);
  const double at_rest = fluid_momentum(world_, water_).linear.x;
  double pushed = 0;
  float opposed = 0;
  for (int k = 1; k <= 40; ++k) {
    world_.move_body(plate, {{0.4f + 0.5f * dt * float(k), 0.32f, 0.2f}, {0, 0, 0, 1}}, dt);
    world_.step(dt);
    const BodyState state = world_.body_state(plate);
    pushed -= double{state.fluid_force.x * dt};
    opposed = std::max(opposed, -state.fluid_force.x);
    EXPECT_NEAR(state.pose.position.x, 0.4f + 0.5f * dt * float(k), 1e-4f);  // nothing holds it up
  }
  const double gained = fluid_momentum(world_, water_).linear.x - at_rest;
  EXPECT_GT(gained, 1);
  EXPECT_GT(pushed, gained);  // the far wall takes some
  EXPECT_GT(opposed, 5);
  EXPECT_EQ(world_.diagnostics().outside, 0u);
}

TEST_P(PaddleTest, AMotorDoesWorkOnWater) {
  const BodyId blade =
      world_.create_body(body(BoxGeometry{{0.03f, 0.25f, 0.15f}}, {0.6f, 0.35f, 0.2f}, 2000));
  const JointId joint = hinge(blade, {0.6f, 0.6f, 0.2f}, {{}, {}, 2, 200});
  fill({1.2f, 1.2f, 0.4f}, 0.4f);
  const double before = energy(world_);
  double work = 0;
  for (int k = 0; k < 60; ++k) {
    world_.step(dt);
    const BodyState state = world_.body_state(blade);
    work -= double{
        dt * (dot(state.fluid_torque, state.angular_velocity) + dot(state.fluid_force, state.velocity))};
  }
  EXPECT_GT(std::fabs(world_.hinge_angle(joint)), 1);  // it turns, if not as fast as in air
  EXPECT_GT(work, 5);
  EXPECT_GT(energy(world_) - before, 1);
  EXPECT_LT(energy(world_) - before, 1.1 * work);
}

TEST_P(PaddleTest, AJetTurnsAWheel) {
  CompoundGeometry wheel;
  for (int n = 0; n < 4; ++n) {
    CompoundPart blades = part(BoxGeometry{{0.3f, 0.02f, 0.12f}}, {0, 0, 0});
    blades.pose.rotation = about_z(45.0f * float(n));
    wheel.parts.push_back(blades);
  }
  const BodyId id = world_.create_body(body(wheel, {0, 0, 0}, 700));
  hinge(id, {0, 0, 0}, {});
  world_.create_sink({"", BoxRegion{{-2, -1, -2}, {2, 2, 2}}, true, {}, {}});
  const float speed = 3;
  for (int k = 0; k < 150; ++k) {
    if (k % 2 == 0) {
      const std::vector<Vec3> jet = lattice(3, 2, 4, s, {0.15f, 0.6f, -0.1f});
      world_.add_particles(water_, jet, std::vector<Vec3>(jet.size(), Vec3{0, -speed, 0}));
    }
    world_.step(dt);
  }
  const BodyState state = world_.body_state(id);
  const float impact = std::sqrt(speed * speed + 2 * 9.81f * 0.5f);
  RecordProperty("rad_per_s", std::to_string(state.angular_velocity.z));
  EXPECT_LT(state.angular_velocity.z, -2);
  EXPECT_GT(state.angular_velocity.z, -impact / 0.15f);  // no faster than the jet at its inner edge
  EXPECT_NEAR(length(state.pose.position), 0, 1e-3f);
}

MENISCUS_ON_EACH_DEVICE(PaddleTest);

}  // namespace
}  // namespace meniscus::tests
