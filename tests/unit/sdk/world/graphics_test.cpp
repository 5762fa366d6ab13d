// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Particles for renderers, as the CPU device writes them to arrays of the caller's.
#include <gtest/gtest.h>

#include <cstring>

#include "tests/expect_error.h"
#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

constexpr float s = 0.05f;

struct Written {
  std::vector<Ellipsoid> ellipsoids;
  std::vector<uint32_t> fluids;
  std::vector<Vec3> velocities;

  explicit Written(const World& world)
      : ellipsoids(world.particle_count()),
        fluids(world.particle_count()),
        velocities(world.particle_count()) {
    world.write_particles({ellipsoids.data(), fluids.data(), velocities.data()});
  }
};

/// A block that falls apart, of two fluids.
World falling() {
  World world(world_def(pbd::DeviceKind::cpu, s));
  world.add_particles(world.create_fluid({}), lattice(6, 8, 6, s, {0, 0.1f, 0}));
  world.add_particles(world.create_fluid({}), lattice(6, 8, 6, s, {6 * s, 0.1f, 0}));
  world.create_shape(shape(PlaneGeometry{}));
  return world;
}

void expect_as_read(const World& world) {
  const Written written(world);
  const std::span<const Ellipsoid> read = world.ellipsoids();
  EXPECT_EQ(std::memcmp(written.ellipsoids.data(), read.data(), read.size_bytes()), 0);
  const std::span<const Vec3> velocities = world.velocities();
  EXPECT_EQ(std::memcmp(written.velocities.data(), velocities.data(), velocities.size_bytes()), 0);
}

TEST(WorldGraphics, WritesWhatIsRead) {
  const World world = falling();
  expect_as_read(world);
  const std::span<const uint32_t> fluids = world.fluids();
  EXPECT_EQ(Written(world).fluids, std::vector<uint32_t>(fluids.begin(), fluids.end()));
}

TEST(WorldGraphics, WritesVelocitiesOnlyWhereThereIsAnArray) {
  World world = falling();
  for (int k = 0; k < 5; ++k) world.step(0.01f);
  std::vector<Ellipsoid> ellipsoids(world.particle_count());
  std::vector<uint32_t> fluids(world.particle_count());
  world.write_particles({ellipsoids.data(), fluids.data()});
  const Written with(world);
  EXPECT_EQ(std::memcmp(with.ellipsoids.data(), ellipsoids.data(), sizeof(Ellipsoid) * ellipsoids.size()), 0);
  const std::span<const Vec3> read = world.velocities();
  EXPECT_EQ(with.velocities, std::vector<Vec3>(read.begin(), read.end()));
  EXPECT_LT(with.velocities.back().y, -0.1f);
}

TEST(WorldGraphics, GoesByTheLastSubstepsNeighbours) {
  World world = falling();
  for (int k = 0; k < 20; ++k) world.step(0.01f);
  const Written written(world);
  const std::span<const Ellipsoid> read = world.ellipsoids();
  float apart = 0;
  for (std::size_t i = 0; i < read.size(); ++i)
    apart = std::max(apart, length(written.ellipsoids[i].centre - read[i].centre));
  EXPECT_LT(apart, 0.02f * s);
}

TEST(WorldGraphics, DoesNotGoByNeighboursOfOthers) {
  World world = falling();
  world.step(0.01f);
  world.remove_particles(std::vector<ParticleId>{3, 200, 400});
  expect_as_read(world);
  world.step(0.01f);
  world.diagnostics();  // looks for neighbours of its own
  expect_as_read(world);
}

TEST(WorldGraphics, LeavesNoTrace) {
  World world = falling(), other = falling();
  for (int k = 0; k < 5; ++k) {
    for (World* w : {&world, &other}) w->step(0.01f);
    const Written seen(world);
  }
  EXPECT_EQ(world.state_hash(), other.state_hash());
}

TEST(WorldGraphics, SaysWhatIsWrong) {
  const World world = falling();
  std::vector<Ellipsoid> ellipsoids(world.particle_count());
  expect_error(ErrorCode::invalid_argument, "ParticleArrays::fluids", [&] {
    world.write_particles({ellipsoids.data(), nullptr});
  });
  expect_error(ErrorCode::invalid_argument, "ParticleArrays::ellipsoids", [&] { world.write_particles({}); });
  expect_error(ErrorCode::device, "OpenGL", [] { GlParticles(1, 2); });  // there is no context
}

}  // namespace
}  // namespace meniscus::tests
