// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Light bodies between water and heavy solids, with contacts that the device solves: 4 substeps of 10
// iterations, both of the water and of solids.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/coupling/body_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float s = 0.05f, dt = 0.016f;

WorldDef loaded_def(pbd::DeviceKind device) {
  WorldDef def = world_def(device, s);
  def.substeps = 4;
  def.iterations = 10;
  def.rigid.solver = RigidSolver::device;
  return def;
}

BodyDef box_of(Vec3 half_extents, Vec3 position, float mass) {
  BodyDef def = body(BoxGeometry{half_extents}, position, 1);
  def.mass = mass;
  def.can_sleep = false;
  return def;
}

void add_water(World& world, Vec3 lower, Vec3 upper) {
  FluidDef water;
  water.xsph = 20;
  world.add_fluid(block(world.create_fluid(water), lower, upper));
}

/// A raft of 0.6 x 0.2 x 0.6 m in a tank of 1 m², which draws 0.1 m with its load.
struct Raft {
  static constexpr float heavy = 36;
  World world;
  BodyId raft{}, load{};

  /// The load is `ratio` times as heavy as the raft; 0: the raft has the mass of both. `half_width`: m.
  Raft(pbd::DeviceKind device, float ratio, float half_width = 0.2f) : world(loaded_def(device)) {
    world.create_shape(tank({-0.5f, 0, -0.5f}, {0.5f, 1.5f, 0.5f}));
    const float own = ratio > 0 ? heavy / ratio : heavy;
    raft = world.create_body(box_of({0.3f, 0.1f, 0.3f}, {0, 0.4f, 0}, own));
    if (ratio > 0) load = world.create_body(box_of({half_width, 0.03f, half_width}, {0, 0.53f, 0}, heavy));
    add_water(world, {-0.5f, 0, -0.5f}, {0.5f, 0.4f, 0.5f});
  }
  /// m: of the raft, on average over the last of the steps.
  float height(int steps) {
    run(world, steps - 20, dt);
    float sum = 0;
    for (int k = 0; k < 20; ++k) {
      world.step(dt);
      sum += world.body_state(raft).pose.position.y / 20;
    }
    return sum;
  }
};

}  // namespace

class LoadedBodies : public OnDevice {};

TEST_P(LoadedBodies, ALightRaftFloatsAsDeepAsWhatItCarries) {
  constexpr int steps = 60;
  const float alone = Raft(GetParam(), 0).height(steps);
  Raft carried(GetParam(), 300);
  EXPECT_NEAR(carried.height(steps), alone, 0.03f * 0.2f);
  const BodyState raft = carried.world.body_state(carried.raft),
                  load = carried.world.body_state(carried.load);
  EXPECT_NEAR(load.pose.position.y - raft.pose.position.y, 0.13f, 0.002f);
  EXPECT_LT(length(raft.velocity), 0.05f);
  const Diagnostics d = carried.world.diagnostics();
  EXPECT_LT(d.density_error_mean, 0.01);
  EXPECT_LT(d.max_speed, 0.5);
}

// A narrow load holds the raft against tilting by its weight times its half width alone.
TEST_P(LoadedBodies, ALightRaftCarriesANarrowLoad) {
  struct Case {
    float ratio, half_width;
  };
  constexpr int steps = 100;
  const float alone = Raft(GetParam(), 0).height(steps);
  for (const auto [ratio, half_width] : {Case{300, 0.05f}, Case{10000, 0.1f}}) {
    Raft carried(GetParam(), ratio, half_width);
    EXPECT_NEAR(carried.height(steps), alone, 0.03f * 0.1f) << ratio;
    const BodyState raft = carried.world.body_state(carried.raft),
                    load = carried.world.body_state(carried.load);
    EXPECT_NEAR(load.pose.position.y - raft.pose.position.y, 0.13f, 0.002f) << ratio;
    EXPECT_LT(length(raft.velocity), 0.05f) << ratio;
    EXPECT_LT(length(raft.angular_velocity), 0.2f) << ratio;
    const Diagnostics d = carried.world.diagnostics();
    EXPECT_LT(d.density_error_mean, 0.01) << ratio;
    EXPECT_LT(d.max_speed, 0.5) << ratio;
  }
}

TEST_P(LoadedBodies, ALightRaftFloatsForAMinute) {
  const float alone = Raft(GetParam(), 0).height(100);
  Raft carried(GetParam(), 300, 0.1f);
  run(carried.world, 125, dt);
  const auto energy = [&] {
    const Diagnostics d = carried.world.diagnostics();
    return d.kinetic_energy + d.potential_energy;
  };
  const double start = energy();
  for (int second = 2; second < 60; second += 2) {
    EXPECT_NEAR(carried.height(125), alone, 0.03f * 0.1f) << second;
    const BodyState raft = carried.world.body_state(carried.raft),
                    load = carried.world.body_state(carried.load);
    EXPECT_NEAR(load.pose.position.y - raft.pose.position.y, 0.13f, 0.002f) << second;
    EXPECT_LT(length(raft.velocity), 0.05f) << second;
    EXPECT_LT(energy(), 1.001 * start) << second;
    EXPECT_LT(carried.world.diagnostics().density_error_mean, 0.01) << second;
  }
}

// A plate of 1 kg that lies on posts, under half a metre of water.
TEST_P(LoadedBodies, ALightPlateBearsAHeavyColumnOfWater) {
  World world(loaded_def(GetParam()));
  world.create_shape(tank({-0.3f, 0, -0.3f}, {0.3f, 1.5f, 0.3f}));
  for (const float x : {-0.2f, 0.2f})
    for (const float z : {-0.2f, 0.2f})
      world.create_shape(shape(BoxGeometry{{0.03f, 0.1f, 0.03f}}, {x, 0.1f, z}));
  const BodyId plate = world.create_body(box_of({0.299f, 0.02f, 0.299f}, {0, 0.22f, 0}, 1));
  add_water(world, {-0.3f, 0.24f, -0.3f}, {0.3f, 0.74f, 0.3f});
  float fastest = 0;
  for (int k = 0; k < 60; ++k) {
    world.step(dt);
    fastest = std::max(fastest, length(world.body_state(plate).velocity));
  }
  EXPECT_NEAR(world.body_state(plate).pose.position.y, 0.22f, 0.002f);
  EXPECT_LT(fastest, 0.1f);
  const Diagnostics d = world.diagnostics();
  EXPECT_LT(d.density_error_mean, 0.002);
  EXPECT_LT(d.max_speed, 1.5);
  const float weight = 180 * 9.81f;
  EXPECT_NEAR(world.body_state(plate).fluid_force.y, -weight, 0.05f * weight);
}

MENISCUS_ON_EACH_DEVICE(LoadedBodies);

}  // namespace meniscus::tests
