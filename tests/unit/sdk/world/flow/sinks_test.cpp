// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of sinks.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

class SinksTest : public OnDevice {
 protected:
  World world_ = make_world();
  FluidId water_ = world_.create_fluid({});

  World make_world() const {
    WorldDef def = world_def(GetParam(), 0.05f);
    def.gravity = {0, 0, 0};
    return World(def);
  }

  /// One particle a metre, at x = 0 to 9.
  void add_row() {
    std::vector<Vec3> row;
    for (int i = 0; i < 10; ++i) row.push_back({float(i), 0, 0});
    world_.add_particles(water_, row);
  }

  std::vector<ParticleId> ids() const { return {world_.ids().begin(), world_.ids().end()}; }
};

TEST_P(SinksTest, WhatIsInsideGoes) {
  add_row();
  world_.create_sink({"", BoxRegion{{2.5f, -1, -1}, {5.5f, 1, 1}}, false, {}, {}});
  EXPECT_EQ(world_.particle_count(), 10u);  // at the end of a step, not before
  EXPECT_EQ(world_.step(0.01f).removed, 3u);
  EXPECT_EQ(ids(), (std::vector<ParticleId>{0, 1, 2, 6, 7, 8, 9}));
  EXPECT_EQ(world_.step(0.01f).removed, 0u);
}

TEST_P(SinksTest, WhatIsOutsideGoes) {
  add_row();
  world_.create_sink({"", BoxRegion{{2.5f, -1, -1}, {5.5f, 1, 1}}, true, {}, {}});
  EXPECT_EQ(world_.step(0.01f).removed, 7u);
  EXPECT_EQ(ids(), (std::vector<ParticleId>{3, 4, 5}));
}

TEST_P(SinksTest, ADestroyedSinkTakesNothing) {
  add_row();
  const SinkId first = world_.create_sink({"", BoxRegion{{-1, -1, -1}, {0.5f, 1, 1}}, false, {}, {}});
  const SinkId second = world_.create_sink({"", BoxRegion{{8.5f, -1, -1}, {10, 1, 1}}, false, {}, {}});
  world_.destroy_sink(first);
  EXPECT_EQ(world_.step(0.01f).removed, 1u);
  EXPECT_EQ(ids().front(), 0u);
  world_.destroy_sink(second);
  add_row();
  EXPECT_EQ(world_.step(0.01f).removed, 0u);
}

TEST_P(SinksTest, AWorldCanBeEmptiedAndFilledAgain) {
  add_row();
  const SinkId sink = world_.create_sink({"", BoxRegion{{-1, -1, -1}, {20, 1, 1}}, false, {}, {}});
  EXPECT_EQ(world_.step(0.01f).removed, 10u);
  EXPECT_EQ(world_.particle_count(), 0u);
  EXPECT_EQ(world_.step(0.01f).removed, 0u);
  EXPECT_EQ(world_.diagnostics().particles, 0u);
  world_.destroy_sink(sink);
  add_row();
  world_.step(0.01f);
  EXPECT_EQ(ids().front(), 10u);
  EXPECT_EQ(ids().size(), 10u);
}

TEST_P(SinksTest, WhatStaysGoesOnAsItWas) {
  const Vec3 v{1, 2, 3};
  const std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, velocities{{0, 0, 0}, v, {0, 0, 0}};
  world_.add_particles(water_, positions, velocities);
  world_.create_sink({"", BoxRegion{{-0.5f, -9, -9}, {0.5f, 9, 9}}, false, {}, {}});
  world_.step(0.01f);
  EXPECT_EQ(ids(), (std::vector<ParticleId>{1, 2}));
  EXPECT_LT(length(world_.positions()[0] - (positions[1] + 0.01f * v)), 1e-5f);
  EXPECT_LT(length(world_.velocities()[0] - v), 1e-3f);
}

TEST_P(SinksTest, ABallTakesWhatIsInside) {
  add_row();
  SinkDef sink;
  sink.region = BallRegion{1.5f};
  sink.pose.position = {4, 0.5f, 0};
  world_.create_sink(sink);
  EXPECT_EQ(world_.step(0.01f).removed, 3u);
  EXPECT_EQ(ids(), (std::vector<ParticleId>{0, 1, 2, 6, 7, 8, 9}));
}

TEST_P(SinksTest, AHalfSpaceTakesWhatIsBelow) {
  add_row();
  SinkDef sink;
  sink.region = HalfSpaceRegion{{-3, 0, 0}, -10.5f};  // x > 3.5
  world_.create_sink(sink);
  EXPECT_EQ(world_.step(0.01f).removed, 6u);
  EXPECT_EQ(ids(), (std::vector<ParticleId>{0, 1, 2, 3}));
}

TEST_P(SinksTest, ABoxMayBeTurned) {
  add_row();
  SinkDef sink;
  sink.region = BoxRegion{{-0.1f, -2.6f, -0.1f}, {0.1f, 2.6f, 0.1f}};
  sink.pose = {{5, 0, 0}, about_z(90)};
  world_.create_sink(sink);
  EXPECT_EQ(world_.step(0.01f).removed, 5u);
  EXPECT_EQ(ids(), (std::vector<ParticleId>{0, 1, 2, 8, 9}));
}

TEST_P(SinksTest, ABodyCarriesOne) {
  add_row();
  BodyDef cart;
  cart.geometry = SphereGeometry{0.1f};
  cart.motion = BodyMotion::kinematic;
  cart.filter = {2, 2};
  cart.pose.position = {-1, 1, 0};
  const BodyId body = world_.create_body(cart);
  SinkDef sink;
  sink.region = BallRegion{0.3f};
  sink.pose.position = {0, -1, 0};
  sink.body = body;
  const SinkId id = world_.create_sink(sink);
  EXPECT_EQ(world_.step(0.01f).removed, 0u);
  world_.move_body(body, {{4.2f, 1, 0}, {0, 0, 0, 1}}, 0.5f);  // removes the particles along its path
  for (int k = 0; k < 50; ++k) world_.step(0.01f);
  EXPECT_EQ(ids(), (std::vector<ParticleId>{5, 6, 7, 8, 9}));
  EXPECT_EQ(world_.sink_count(id).total, 5u);
}

TEST_P(SinksTest, EachCountsWhatItTook) {
  add_row();
  const SinkId first = world_.create_sink({"", BoxRegion{{2.5f, -1, -1}, {5.5f, 1, 1}}, false, {}, {}});
  const SinkId second = world_.create_sink({"", BoxRegion{{4.5f, -1, -1}, {8.5f, 1, 1}}, false, {}, {}});
  EXPECT_EQ(world_.sink_count(first).total, 0u);
  EXPECT_EQ(world_.step(0.01f).removed, 6u);
  EXPECT_EQ(world_.sink_count(first).last_step, 3u);  // 3, 4, and 5, which both would take
  EXPECT_EQ(world_.sink_count(second).last_step, 3u);
  world_.step(0.01f);
  EXPECT_EQ(world_.sink_count(first).last_step, 0u);
  EXPECT_EQ(world_.sink_count(first).total, 3u);
  world_.destroy_sink(first);
  EXPECT_THROW(world_.sink_count(first), Error);
  EXPECT_EQ(world_.sink_count(second).total, 3u);
}

MENISCUS_ON_EACH_DEVICE(SinksTest);

}  // namespace
}  // namespace meniscus::tests
