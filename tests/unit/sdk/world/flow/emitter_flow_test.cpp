// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The number of particles that an emitter creates, when, and where they are.
#include <gtest/gtest.h>

#include "tests/unit/sdk/world/flow/emitter_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float s = emitter_spacing;
constexpr double pi_d = std::numbers::pi;

class EmitterFlowTest : public OnDevice {
 protected:
  World world_{weightless(GetParam(), s)};
  FluidId water_ = world_.create_fluid({});

  void run_for(double seconds, float dt = 1.0f / 60) {
    run(world_, static_cast<int>(std::lround(seconds / double{dt})), dt);
  }
  EmitterId jet(float radius = 4.3f * s, float speed = 2) {
    return world_.create_emitter(emitter(water_, DiscOpening{radius}, speed));
  }
};

TEST_P(EmitterFlowTest, ADiscGivesSpeedTimesArea) {
  for (float radius : {0.3f * s, 0.9f * s, 1.6f * s, 3.3f * s}) {
    World world(weightless(GetParam(), s));
    const EmitterId id = world.create_emitter(emitter(world.create_fluid({}), DiscOpening{radius}, 3));
    run(world, 60, 1.0f / 60);
    const double expected = 3 * pi_d * radius * radius;
    const double layer = std::max(1.0, pi_d * radius * radius / (s * s)) * s * s * s;
    EXPECT_NEAR(emitted_volume(world, id), expected, 0.01 * expected + layer) << radius / s;
    EXPECT_GT(nearest_pair(world), 0.69f) << radius / s;
  }
}

TEST_P(EmitterFlowTest, SoDoesARectangleOfAnySides) {
  for (auto [width, depth] : {std::pair{1.4f, 1.4f}, {0.5f, 7.3f}, {2.5f, 3.5f}, {5.0f, 4.0f}}) {
    World world(weightless(GetParam(), s));
    const RectangleOpening opening{width * s, depth * s};
    const EmitterId id = world.create_emitter(emitter(world.create_fluid({}), opening, 3));
    run(world, 60, 1.0f / 60);
    const double expected = 3.0 * opening.width * opening.depth;
    EXPECT_NEAR(emitted_volume(world, id), expected, 0.01 * expected + 2 * width * depth * s * s * s);
    EXPECT_GT(nearest_pair(world), 0.69f);
  }
}

TEST_P(EmitterFlowTest, OverALongTimeTheVolumeIsExact) {
  const EmitterId id = jet(2.7f * s);
  world_.create_sink({"", BallRegion{0.5f}, true, {}, {}});
  run_for(10);
  const double expected = 10 * 2 * pi_d * std::pow(2.7 * double{s}, 2);
  EXPECT_NEAR(emitted_volume(world_, id) / expected, 1, 0.003);
}

TEST_P(EmitterFlowTest, ARateIsWhatLeaves) {
  EmitterDef def = emitter(water_, DiscOpening{3 * s}, 2);
  def.rate = 0.02f;  // of .141 m³/s
  const EmitterId id = world_.create_emitter(def);
  run_for(2);
  EXPECT_NEAR(emitted_volume(world_, id), 0.04, 0.0004);
}

// With little to give, places take turns: no pulses.
TEST_P(EmitterFlowTest, ARateIsEven) {
  EmitterDef def = emitter(water_, DiscOpening{3 * s}, 2);
  def.rate = 0.02f;
  const EmitterId id = world_.create_emitter(def);
  run_for(1);
  uint32_t least = 1000, most = 0;
  for (int k = 0; k < 60; ++k) {
    const uint32_t made = world_.step(1.0f / 60).emitted;
    EXPECT_EQ(made, world_.emitter_count(id).last_step);
    least = std::min(least, made);
    most = std::max(most, made);
  }
  EXPECT_LE(most - least, 2u) << least << " to " << most;  // 2.7 a step
}

TEST_P(EmitterFlowTest, TheStepLeavesNoMarkOnTheJet) {
  for (float dt : {1.0f / 30, 1.0f / 60, 1.0f / 120, 0.0071f}) {
    World world(weightless(GetParam(), s));
    const FluidId water = world.create_fluid({});
    const EmitterId id = world.create_emitter(emitter(water, RectangleOpening{4 * s, 4 * s}, 2));
    while (world.time() < 0.5) world.step(dt);
    const double layers = 2 * world.time() / double{s};
    EXPECT_NEAR(static_cast<double>(world.emitter_count(id).total) / 16, layers, 1) << dt;
    // Sixteen columns of particles a spacing apart, whatever the step.
    EXPECT_GT(nearest_pair(world), 0.995f) << dt;
    for (size_t i = 16; i < world.particle_count(); ++i)
      EXPECT_NEAR(length(world.positions()[i - 16] - world.positions()[i]), s, 0.005f * s) << dt;
  }
}

TEST_P(EmitterFlowTest, WhatLeavesFallsFromTheMomentThatItLeaves) {
  WorldDef def = world_def(GetParam(), s);
  def.substeps = 50;
  World world(def);
  EmitterDef thrower = emitter(world.create_fluid({}), DiscOpening{0.4f * s}, 3);
  thrower.pose.rotation = about_z(-90);  // along x
  world.create_emitter(thrower);
  run(world, 20, 0.02f);
  ASSERT_GT(world.particle_count(), 5u);
  for (size_t i = 0; i < world.particle_count(); ++i) {
    const Vec3 p = world.positions()[i], v = world.velocities()[i];
    EXPECT_NEAR(v.x, 3, 1e-3);
    const float age = -v.y / 9.81f, front = p.x - 3 * age;
    EXPECT_NEAR(p.y, -0.5f * 9.81f * age * age, 0.004f);
    EXPECT_NEAR(front, world.positions()[0].x + 3 * world.velocities()[0].y / 9.81f, 1e-3);
  }
}

TEST_P(EmitterFlowTest, AJetHasItsRestDensityFromTheStart) {
  jet(5.2f * s);
  run_for(0.3);
  EXPECT_GT(world_.particle_count(), 900u);
  const Diagnostics d = world_.diagnostics();
  EXPECT_LT(d.density_error_max, 0.005);
  EXPECT_LT(d.density_error_interior, 0.005);
  EXPECT_NEAR(d.max_speed, 2, 0.01);
}

// What has nothing behind it would be pushed back, what follows be put into it: a jet that is not held at its
// root shakes itself to pieces in half a second.
TEST_P(EmitterFlowTest, ALongJetStaysAsItIs) {
  world_.create_emitter(emitter(water_, RectangleOpening{6 * s, 6 * s}, 3));
  run_for(0.8);
  EXPECT_EQ(world_.particle_count(), 48u * 36);
  for (Vec3 v : world_.velocities()) EXPECT_LT(length(v - Vec3{0, 3, 0}), 0.01f);
}

TEST_P(EmitterFlowTest, ItStartsAndStops) {
  EmitterDef def = emitter(water_, RectangleOpening{2 * s, 2 * s}, 1);
  def.start = 0.5f;
  def.stop = 1.5f;
  const EmitterId id = world_.create_emitter(def);
  run_for(0.5);
  EXPECT_EQ(world_.particle_count(), 0u);
  run_for(0.5);
  EXPECT_NEAR(double(world_.particle_count()), 40, 4);
  run_for(2);
  EXPECT_EQ(world_.particle_count(), 80u);  // 20 layers of 4
  EXPECT_EQ(world_.emitter_count(id).last_step, 0u);
}

TEST_P(EmitterFlowTest, ItMakesNoMoreThanItMay) {
  EmitterDef def = emitter(water_, RectangleOpening{3 * s, 3 * s}, 1);
  def.most_particles = 50;
  const EmitterId id = world_.create_emitter(def);
  run_for(2);
  EXPECT_EQ(world_.particle_count(), 50u);
  EXPECT_EQ(world_.emitter_count(id).total, 50u);
  EXPECT_EQ(world_.step(0.01f).emitted, 0u);
}

/// A step may be so short that a particle cannot keep its velocity until it is far enough.
TEST_P(EmitterFlowTest, ParticlesThatAreLetGoTooSoonAreCounted) {
  constexpr float speed = 1;
  const float far = world_.support_radius() / speed;
  world_.create_emitter(emitter(water_, DiscOpening{s}, speed));
  StepReport report = world_.step(far / 100);
  while (report.emitted == 0) report = world_.step(far / 100);
  EXPECT_EQ(report.overflows.emitter_hold, 0u);
  do {
    report = world_.step(far / 1000);
  } while (report.emitted == 0);
  EXPECT_EQ(report.overflows.emitter_hold, report.emitted);
}

TEST_P(EmitterFlowTest, OneMadeLateStartsThen) {
  run_for(1);
  jet();
  EXPECT_EQ(world_.step(0.001f).emitted, 0u);
  run_for(0.1);
  for (Vec3 p : world_.positions()) EXPECT_LT(p.y, 0.5f * s + 0.105f * 2);
}

TEST_P(EmitterFlowTest, ADestroyedOneMakesNothing) {
  const EmitterId first = jet(), second = world_.create_emitter(emitter(water_, DiscOpening{s}, 1));
  world_.destroy_emitter(first);
  run_for(0.5);
  EXPECT_EQ(world_.emitter_count(second).total, world_.particle_count());
  expect_error(ErrorCode::not_found, "emitter", [&] { world_.emitter_count(first); });
  expect_error(ErrorCode::not_found, "emitter", [&] { world_.destroy_emitter(first); });
}

MENISCUS_ON_EACH_DEVICE(EmitterFlowTest);

}  // namespace
}  // namespace meniscus::tests
