// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The effect of water on bodies, in scenes of a few seconds: buoyancy, drag and added mass.
// validation/rigid_draft_test.cpp measures the draft of a box.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/coupling/body_worlds.h"
#include "tests/rigid_solvers.h"

namespace meniscus::tests {
namespace {

constexpr float s = 0.05f, dt = 0.016f, gravity = 9.81f;

class FloatingBodiesTest : public WithSolver {
 protected:
  /// A tank of 0.8 × 0.7 m with water up to `depth`; bodies come first, so that water leaves them room.
  static void add_tank(World& world) { world.create_shape(tank({-0.4f, 0, -0.35f}, {0.4f, 2.5f, 0.35f})); }
  static FluidId add_water(World& world, float depth, float xsph = 5) {
    FluidDef water;
    water.xsph = xsph;
    const FluidId id = world.create_fluid(water);
    world.add_fluid(block(id, {-0.4f, 0, -0.35f}, {0.4f, depth, 0.35f}));
    return id;
  }

  /// The upward speed of a neutral ball in mid water, this much higher, after a push that starts when the
  /// water has come to rest; the push is in weights of the ball.
  static double speed_after_push(float push, float seconds, float higher) {
    World world(world_def(GetParam(), s));
    add_tank(world);
    BodyDef def = body(SphereGeometry{0.15f}, {0, 0.5f + higher, 0}, 1000);
    def.can_sleep = false;
    const BodyId ball = world.create_body(def);
    add_water(world, 1, 0);
    run(world, 40, dt);
    const float force = push * world.body_mass(ball).mass * gravity;
    for (float t = 0; t < seconds - 0.5f * dt; t += dt) {
      world.apply_force(ball, {0, force, 0}, world.body_state(ball).centre_of_mass);
      world.step(dt);
    }
    return double{world.body_state(ball).velocity.y};
  }
};

// A ball accelerates half of its displaced mass (Lamb 1932, §92), so that a force acts on 1.5 times its mass.
// Drag and near walls slow it further. The motion of the water without the ball is the same for a push up and
// one down, except for rounding. Rounding changes the fraction by some hundredths, so four balls are averaged
// that are a micrometre apart.
TEST_P(FloatingBodiesTest, ABallMovesWithItsAddedMass) {
  constexpr float push = 0.7f, seconds = 0.16f, apart = 1e-6f;
  constexpr int balls = 4;
  double gained = 0;
  for (int k = 0; k < balls; ++k) {
    const float higher = apart * static_cast<float>(k);
    gained += speed_after_push(push, seconds, higher) - speed_after_push(-push, seconds, higher);
  }
  gained /= 2 * balls;
  const double share = gained / double{push * gravity / 1.5f * seconds};
  RecordProperty("share", std::to_string(share));
  EXPECT_GT(share, 0.7);
  EXPECT_LT(share, 1.05);
}

// Within 1.3 s of being let go.
TEST_P(FloatingBodiesTest, AHeavyBallSinksAndALightOneRises) {
  for (float density : {300.0f, 3000.0f}) {
    World world(world_def(GetParam(), s));
    add_tank(world);
    const BodyId ball = world.create_body(body(SphereGeometry{0.15f}, {0, 0.5f, 0}, density));
    add_water(world, 1);
    float fastest = 0;
    for (int k = 0; k < 80; ++k) {
      world.step(dt);
      fastest = std::max(fastest, std::fabs(world.body_state(ball).velocity.y));
    }
    const float y = world.body_state(ball).pose.position.y;
    if (density < 1000) {
      EXPECT_GT(y, 0.95f);
      EXPECT_LT(y, 1.15f);
    } else {
      EXPECT_NEAR(y, 0.15f, 0.01f);
    }
    // Not slower than a drag coefficient of 2 allows, nor as fast as without any.
    const float ratio = std::fabs(density / 1000 - 1), way = density < 1000 ? 0.5f : 0.35f;
    EXPECT_GT(fastest, 0.5f * std::sqrt(gravity * ratio * 8 * 0.15f / 3 / 2)) << density;
    EXPECT_LT(fastest, std::sqrt(2 * gravity * ratio / (density / 1000 + 0.5f) * way)) << density;
  }
}

// A ball on a peg, with water beneath it. No particle gets beneath the peg: a film pushes its foot up.
TEST_P(FloatingBodiesTest, OnTheFloorItPressesWithItsWeightLessItsLift) {
  WorldDef def = world_def(GetParam(), s);
  def.substeps = 1;  // so that each contact can be read
  World world(def);
  add_tank(world);
  const CompoundGeometry on_peg{
      {part(SphereGeometry{0.18f}, {0, 0, 0}), part(BoxGeometry{{0.03f, 0.1f, 0.03f}}, {0, -0.23f, 0})}};
  BodyDef ball_def = body(on_peg, {0, 0.33f, 0}, 2500);
  ball_def.can_sleep = false;
  const BodyId ball = world.create_body(ball_def);
  constexpr float step = 0.004f;
  add_water(world, 0.7f, 50);
  run(world, 200, step);
  double lift = 0, floor = 0;
  constexpr int steps = 150;
  for (int k = 0; k < steps; ++k) {
    world.step(step);
    lift += double{world.body_state(ball).fluid_force.y} / steps;
    for (const SolidContact& c : world.solid_contacts()) {
      floor += double{c.impulse * c.normal.y / step} / steps;
    }
  }
  const BodyMass mass = world.body_mass(ball);
  const double weight = double{mass.mass * gravity};
  const double expected = 1000 * double{gravity * mass.volume};
  RecordProperty("lift_over_expected", std::to_string(lift / expected));
  EXPECT_NEAR(lift, expected, 0.03 * expected);
  EXPECT_NEAR(floor, weight - lift, 0.01 * weight);
}

// A raft up to a thousand times lighter than what it carries, at the settings that RigidSolverDef names.
TEST_P(FloatingBodiesTest, ALightRaftCarriesAHeavyBox) {
  for (float ratio : {1.0f, 1000.0f}) {
    WorldDef def = world_def(GetParam(), s);
    def.substeps = 16;
    def.rigid.iterations = 50;
    World world(def);
    add_tank(world);
    constexpr float heavy = 20;
    BodyDef raft = body(BoxGeometry{{0.3f, 0.1f, 0.3f}}, {0, 0.41f, 0}, 1), load = raft;
    raft.mass = heavy / ratio;
    load.geometry = BoxGeometry{{0.1f, 0.1f, 0.1f}};
    load.pose.position.y = 0.611f;
    load.mass = heavy;
    const BodyId under = world.create_body(raft), on_top = world.create_body(load);
    add_water(world, 0.4f, 20);
    float overlap = 0, fastest = 0;
    for (int k = 0; k < 40; ++k) {
      world.step(dt);
      for (const SolidContact& c : world.solid_contacts()) overlap = std::max(overlap, -c.distance);
      fastest = std::max(fastest, length(world.body_state(under).velocity));
    }
    const BodyState carried = world.body_state(on_top), carrier = world.body_state(under);
    RecordProperty("overlap_mm_" + std::to_string(int(ratio)), std::to_string(1000 * overlap));
    EXPECT_LT(overlap, 0.002f) << "ratio " << ratio;  // 1 % of the smaller one's size
    EXPECT_LT(fastest, 3) << "ratio " << ratio;
    EXPECT_GT(carried.pose.position.y, carrier.pose.position.y + 0.15f) << "ratio " << ratio;
    EXPECT_LT(world.diagnostics().max_speed, 5) << "ratio " << ratio;
  }
}

// Heavy on light and light on heavy, in a pile on the floor under water.
TEST_P(FloatingBodiesTest, APileUnderWaterDoesNotSinkIntoItself) {
  for (bool heavy_first : {true, false}) {
    WorldDef def = world_def(GetParam(), s);
    def.rigid.substeps = 4;  // of 1 ms
    def.rigid.iterations = 50;
    World world(def);
    add_tank(world);
    std::vector<BodyId> pile;
    for (int n = 0; n < 3; ++n) {
      const float density = (n % 2 == 0) == heavy_first ? 8000.0f : 1100.0f;
      pile.push_back(world.create_body(
          body(BoxGeometry{{0.1f, 0.08f, 0.1f}}, {0, 0.08f + 0.161f * float(n), 0}, density)));
    }
    add_water(world, 0.6f, 20);
    float overlap = 0;
    for (int k = 0; k < 60; ++k) {
      world.step(dt);
      for (const SolidContact& c : world.solid_contacts()) overlap = std::max(overlap, -c.distance);
    }
    EXPECT_LT(overlap, 0.0016f);  // 1 %
    for (int n = 0; n < 3; ++n) {
      EXPECT_NEAR(world.body_state(pile[size_t(n)]).pose.position.y, 0.08f + 0.16f * float(n), 0.005f);
    }
  }
}

MENISCUS_WITH_EACH_RIGID_SOLVER(FloatingBodiesTest);

}  // namespace
}  // namespace meniscus::tests
