// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The same calls give the same bits: run after run, and whatever the number of threads. And looking does not
// change what is looked at.
#include <gtest/gtest.h>

#include "tests/many_threads.h"
#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

/// Two fluids, walls, a ball as an obstacle, friction, vorticity, artificial pressure: as many features as
/// fit.
World busy_world(WorldDef def) {
  def.density.artificial_pressure.strength = 0.05f;
  World world(def);
  FluidDef first, second;
  first.vorticity_confinement = 0.2f;
  second.rest_density = 500;
  second.dynamic_viscosity = 1;
  const FluidId a = world.create_fluid(first), b = world.create_fluid(second);
  ShapeDef walls = tank({0, 0, 0}, {1, 1, 0.6f});
  walls.surface.friction = 0.3f;
  world.create_shape(walls);
  world.create_shape(shape(SphereGeometry{0.15f}, {0.7f, 0.1f, 0.3f}));
  world.add_fluid(block(a, {0, 0, 0}, {0.4f, 0.5f, 0.6f}));
  world.add_fluid(block(b, {0, 0.5f, 0}, {0.4f, 0.8f, 0.6f}));
  return world;
}

uint64_t hash_after(const WorldDef& def, int steps) {
  World world = busy_world(def);
  run(world, steps, 0.016f);
  return world.state_hash();
}

class DeterminismTest : public OnDevice {};

TEST_P(DeterminismTest, ThreeRunsAreAlike) {
  const WorldDef def = world_def(GetParam(), 0.05f);
  const uint64_t first = hash_after(def, 25);
  EXPECT_EQ(hash_after(def, 25), first);
  EXPECT_EQ(hash_after(def, 25), first);
}

TEST_P(DeterminismTest, TwoWorldsAtOnceDoNotMeet) {
  const WorldDef def = world_def(GetParam(), 0.05f);
  World a = busy_world(def), b = busy_world(def), other = dam_break(def);
  for (int k = 0; k < 20; ++k) {
    a.step(0.016f);
    other.step(0.016f);
    b.step(0.016f);
  }
  EXPECT_EQ(a.state_hash(), b.state_hash());
}

TEST_P(DeterminismTest, ReadOutsLeaveNoTrace) {
  const WorldDef def = world_def(GetParam(), 0.05f);
  World watched = busy_world(def), alone = busy_world(def);
  for (int k = 0; k < 30; ++k) {
    watched.step(0.016f);
    alone.step(0.016f);
    const uint64_t hash = watched.state_hash();
    watched.diagnostics();
    watched.density_errors();
    watched.pressures();
    watched.fluids();
    EXPECT_EQ(watched.state_hash(), hash);
  }
  EXPECT_EQ(watched.state_hash(), alone.state_hash());
}

TEST_P(DeterminismTest, TheSecondLookSeesTheSame) {
  World world = dam_break(GetParam());
  run(world, 30, 0.016f);
  const Diagnostics a = world.diagnostics(), b = world.diagnostics();
  EXPECT_EQ(a.kinetic_energy, b.kinetic_energy);
  EXPECT_EQ(a.density_error_mean, b.density_error_mean);
  EXPECT_EQ(a.density_error_max, b.density_error_max);
  EXPECT_EQ(a.density_error_interior, b.density_error_interior);
  EXPECT_EQ(a.contacts, b.contacts);
  EXPECT_EQ(a.outside, b.outside);
}

TEST_P(DeterminismTest, TheHashSeesEveryBit) {
  World world(world_def(GetParam(), 0.05f)), other(world_def(GetParam(), 0.05f));
  const std::vector<Vec3> here{{1, 2, 3}}, there{{1, 2, std::nextafterf(3, 4)}}, still{{0, 0, 0}},
      moving{{0, 1e-30f, 0}};
  world.add_particles(world.create_fluid({}), here, still);
  other.add_particles(other.create_fluid({}), there, still);
  EXPECT_NE(world.state_hash(), other.state_hash());
  World third(world_def(GetParam(), 0.05f));
  third.add_particles(third.create_fluid({}), here, moving);
  EXPECT_NE(world.state_hash(), third.state_hash());
}

// Drops far away, added after the scene and removed again, change the table's shape, the places in memory
// and, where some go before others, the slots: the scene must not notice.
TEST_P(DeterminismTest, UnrelatedDropsLeaveNoTrace) {
  const WorldDef def = world_def(GetParam(), 0.05f);
  World alone = busy_world(def), crowded = busy_world(def);
  const FluidId drops = crowded.create_fluid({});
  for (const Vec3 away : {Vec3{30, 4, 9}, {-17, 40, 2}, {3, -25, -60}}) {
    crowded.add_particles(drops, lattice(3, 3, 3, 0.05f, away), std::vector<Vec3>(27, {0.3f, 0, -0.2f}));
    run(alone, 8, 0.016f);
    run(crowded, 8, 0.016f);
  }
  const std::vector<ParticleId> all(crowded.ids().begin(), crowded.ids().end());
  const size_t scene = alone.particle_count();
  ASSERT_EQ(all.size(), scene + 3 * 27);
  EXPECT_NE(crowded.state_hash(), alone.state_hash());
  crowded.remove_particles(std::span(all).subspan(scene));
  EXPECT_EQ(crowded.state_hash(), alone.state_hash());
  run(alone, 8, 0.016f);
  run(crowded, 8, 0.016f);
  EXPECT_EQ(crowded.state_hash(), alone.state_hash());
}

// Slots close up when particles go; numbers stay, and with them all that is drawn by chance.
TEST_P(DeterminismTest, RemovedDropsBeforeTheSceneLeaveNoTrace) {
  const auto after_removal = [&](bool at_once) {
    World world(world_def(GetParam(), 0.05f));
    const FluidId drops = world.create_fluid({});
    world.add_particles(drops, lattice(3, 3, 3, 0.05f, {30, 4, 9}), {});
    const std::vector<ParticleId> first(world.ids().begin(), world.ids().end());
    world.create_shape(tank({0, 0, 0}, {1, 1, 0.6f}));
    world.add_fluid(block(world.create_fluid({}), {0, 0, 0}, {0.4f, 0.8f, 0.6f}));
    if (at_once) world.remove_particles(first);
    run(world, 16, 0.016f);
    if (!at_once) world.remove_particles(first);
    run(world, 16, 0.016f);
    return world.state_hash();
  };
  EXPECT_EQ(after_removal(false), after_removal(true));
}

MENISCUS_ON_EACH_DEVICE(DeterminismTest);

TEST(CpuDeterminism, TheNumberOfThreadsLeavesNoTrace) {
  const ManyThreads allowed;
  WorldDef def = world_def(pbd::DeviceKind::cpu, 0.05f);
  def.threads = 1;
  const uint64_t one = hash_after(def, 25);
  for (int threads : {2, 3, 8}) {
    def.threads = threads;
    EXPECT_EQ(hash_after(def, 25), one) << threads << " threads";
  }
}

}  // namespace
}  // namespace meniscus::tests
