// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
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
  world_.create_sink({"", {{2.5f, -1, -1}, {5.5f, 1, 1}}, false});
  EXPECT_EQ(world_.particle_count(), 10u);  // at the end of a step, not before
  EXPECT_EQ(world_.step(0.01f).removed, 3u);
  EXPECT_EQ(ids(), (std::vector<ParticleId>{0, 1, 2, 6, 7, 8, 9}));
  EXPECT_EQ(world_.step(0.01f).removed, 0u);
}

TEST_P(SinksTest, WhatIsOutsideGoes) {
  add_row();
  world_.create_sink({"", {{2.5f, -1, -1}, {5.5f, 1, 1}}, true});
  EXPECT_EQ(world_.step(0.01f).removed, 7u);
  EXPECT_EQ(ids(), (std::vector<ParticleId>{3, 4, 5}));
}

TEST_P(SinksTest, ADestroyedSinkTakesNothing) {
  add_row();
  const SinkId first = world_.create_sink({"", {{-1, -1, -1}, {0.5f, 1, 1}}, false});
  const SinkId second = world_.create_sink({"", {{8.5f, -1, -1}, {10, 1, 1}}, false});
  world_.destroy_sink(first);
  EXPECT_EQ(world_.step(0.01f).removed, 1u);
  EXPECT_EQ(ids().front(), 0u);
  world_.destroy_sink(second);
  add_row();
  EXPECT_EQ(world_.step(0.01f).removed, 0u);
}

TEST_P(SinksTest, AWorldCanBeEmptiedAndFilledAgain) {
  add_row();
  const SinkId sink = world_.create_sink({"", {{-1, -1, -1}, {20, 1, 1}}, false});
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
  world_.create_sink({"", {{-0.5f, -9, -9}, {0.5f, 9, 9}}, false});
  world_.step(0.01f);
  EXPECT_EQ(ids(), (std::vector<ParticleId>{1, 2}));
  EXPECT_LT(length(world_.positions()[0] - (positions[1] + 0.01f * v)), 1e-5f);
  EXPECT_LT(length(world_.velocities()[0] - v), 1e-3f);
}

MENISCUS_ON_EACH_DEVICE(SinksTest);

}  // namespace
}  // namespace meniscus::tests
