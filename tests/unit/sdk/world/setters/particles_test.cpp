// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Positions and velocities of particles that are set from outside.
#include "tests/expect_error.h"
#include "tests/unit/sdk/world/snapshot/cases.h"

namespace meniscus::tests {
namespace {

constexpr int steps = 3;

class SetParticlesTest : public OnDevice {
 protected:
  /// A tank with water and oil, and nothing in their particles that others lack.
  struct Pool {
    explicit Pool(const WorldDef& def) : world(def) {
      world.create_shape(tank({0, 0, 0}, {1, 1, 0.5f}));
      FluidDef oil_def;
      oil_def.name = "oil";
      oil_def.rest_density = 800;
      water = world.create_fluid({}), oil = world.create_fluid(oil_def);
    }
    World world;
    FluidId water, oil;
  };

  WorldDef def_ = world_def(GetParam(), 0.05f);
  std::vector<Vec3> low_ = lattice(8, 4, 8, 0.05f, {0, 0, 0}), high_ = lattice(8, 4, 8, 0.05f, {0, 0.2f, 0});
};

/// The same positions and velocities that were set, or with which new particles were made, have one future.
TEST_P(SetParticlesTest, PlacedParticlesAreLikeNewOnes) {
  Pool made(def_), set(def_);
  const std::vector<Vec3> to = lattice(8, 4, 8, 0.05f, {0.5f, 0.1f, 0});
  std::vector<Vec3> velocities;
  std::mt19937 random(3);
  for (size_t k = 0; k < to.size(); ++k) velocities.push_back(random_vector(random, 0.5f));
  made.world.add_particles(made.water, to, velocities);
  set.world.add_particles(set.water, low_);
  run(set.world, 5, snapshot_step);
  set.world.set_positions(to);
  set.world.set_velocities(velocities);
  EXPECT_EQ(copy_of(set.world.positions()), to);
  EXPECT_EQ(copy_of(set.world.velocities()), velocities);
  EXPECT_EQ(set.world.state_hash(), made.world.state_hash());
  for (int k = 0; k < steps; ++k) {
    made.world.step(snapshot_step), set.world.step(snapshot_step);
    EXPECT_EQ(set.world.state_hash(), made.world.state_hash());
  }
}

TEST_P(SetParticlesTest, OfOneFluid) {
  Pool pool(def_);
  pool.world.add_particles(pool.water, low_);
  pool.world.add_particles(pool.oil, high_);
  pool.world.add_particles(pool.water, lattice(1, 2, 1, 0.05f, {0.9f, 0, 0}));
  run(pool.world, 2, snapshot_step);
  const std::vector<Vec3> before = copy_of(pool.world.positions()), speeds = copy_of(pool.world.velocities());
  const std::vector<Vec3> to = lattice(8, 4, 8, 0.05f, {0.5f, 0.5f, 0});
  const std::vector<Vec3> drift(to.size(), {0, 0, 1});
  pool.world.set_positions(pool.oil, to);
  pool.world.set_velocities(pool.oil, drift);
  for (size_t k = 0; k < before.size(); ++k) {
    const bool is_oil = k >= low_.size() && k < low_.size() + to.size();
    EXPECT_EQ(pool.world.positions()[k], is_oil ? to[k - low_.size()] : before[k]);
    EXPECT_EQ(pool.world.velocities()[k], is_oil ? drift[0] : speeds[k]);
  }
}

TEST_P(SetParticlesTest, ByIdsInAnyOrderAndAfterRemovals) {
  Pool pool(def_);
  pool.world.add_particles(pool.water, low_);
  pool.world.remove_particles(std::vector<ParticleId>{0, 1, 7});
  const std::vector<ParticleId> moved{9, 2, 40};
  const std::vector<Vec3> to{{0.9f, 0.1f, 0.1f}, {0.8f, 0.1f, 0.1f}, {0.7f, 0.1f, 0.1f}};
  const std::vector<Vec3> velocities{{1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  const std::vector<Vec3> before = copy_of(pool.world.positions());
  pool.world.set_positions(moved, to);
  pool.world.set_velocities(moved, velocities);
  for (size_t slot = 0; slot < before.size(); ++slot) {
    const auto at = std::ranges::find(moved, pool.world.ids()[slot]) - moved.begin();
    const bool is_moved = static_cast<size_t>(at) < moved.size();
    EXPECT_EQ(pool.world.positions()[slot], is_moved ? to[static_cast<size_t>(at)] : before[slot]);
    EXPECT_EQ(pool.world.velocities()[slot], is_moved ? velocities[static_cast<size_t>(at)] : Vec3{});
  }
  run(pool.world, 2, snapshot_step);
  EXPECT_EQ(pool.world.diagnostics().non_finite, 0u);
}

/// Multipliers stay, so that nothing changes where the same velocities are set.
TEST_P(SetParticlesTest, TheSameVelocitiesLeaveTheFuture) {
  Pool one(def_), other(def_);
  for (Pool* pool : {&one, &other}) {
    pool->world.add_particles(pool->water, low_);
    run(pool->world, 10, snapshot_step);
  }
  other.world.set_velocities(other.world.velocities());
  EXPECT_EQ(future_of(other.world, steps), future_of(one.world, steps));
}

TEST_P(SetParticlesTest, IsInTheUsersFrame) {
  def_.origin = {100, 0, 0};
  World world(def_);
  const FluidId water = world.create_fluid({});
  world.add_particles(water, std::vector<Vec3>{{100, 1, 0}});
  const std::vector<Vec3> to{{101, 2, 0}};
  world.set_positions(to);
  EXPECT_EQ(copy_of(world.positions()), to);
}

TEST_P(SetParticlesTest, WhatIsPutIntoASolidComesOutSlowly) {
  Pool pool(def_);
  pool.world.create_shape(shape(BoxGeometry{{0.1f, 0.1f, 0.1f}}, {0.5f, 0.1f, 0.25f}));
  pool.world.add_particles(pool.water, std::vector<Vec3>{{0.2f, 0.3f, 0.25f}});
  pool.world.step(snapshot_step);
  pool.world.set_positions(std::vector<Vec3>{{0.42f, 0.1f, 0.25f}});
  pool.world.set_velocities(std::vector<Vec3>{{0, 0, 0}});
  run(pool.world, 10, snapshot_step);
  EXPECT_LT(pool.world.positions()[0].x, 0.4f);
  EXPECT_LT(length(pool.world.velocities()[0]), 3);
}

TEST_P(SetParticlesTest, RefusesTooManyInOnePlace) {
  World world(world_def(GetParam(), 0.05f));
  const FluidId water = world.create_fluid({});
  world.add_particles(water, lattice(26, 26, 26, 0.05f, {0, 0, 0}));
  const uint64_t before = world.state_hash();
  const std::vector<Vec3> one_place(world.particle_count(), {0, 0, 0});
  expect_error(ErrorCode::capacity, "set_positions would put", [&] { world.set_positions(one_place); });
  EXPECT_EQ(world.state_hash(), before);
}

TEST_P(SetParticlesTest, StaysBetweenTheSeams) {
  def_.periodic.x = {0, 1};
  World world(def_);
  const FluidId water = world.create_fluid({});
  world.add_particles(water, std::vector<Vec3>{{0.5f, 0, 0}});
  expect_error(ErrorCode::invalid_argument, "WorldDef::periodic.x", [&] {
    world.set_positions(std::vector<Vec3>{{1.5f, 0, 0}});
  });
}

MENISCUS_ON_EACH_DEVICE(SetParticlesTest);

}  // namespace
}  // namespace meniscus::tests
