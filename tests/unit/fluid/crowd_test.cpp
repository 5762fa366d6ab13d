// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Particles that are created at one point part slowly.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/expect_error.h"
#include "tests/many_threads.h"
#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

constexpr float s = 0.05f, dt = 1 / 60.0f;
constexpr float parting_speed = 0.5f * s / 0.02f;  // a contact radius per .02 s

struct Fastest {
  float velocity = 0;  // m/s, that particles have
  float moved = 0;     // m/s, by which positions changed
};

std::vector<Vec3> copy(std::span<const Vec3> from) {
  return {from.begin(), from.end()};
}

Vec3 mean(std::span<const Vec3> values) {
  double x = 0, y = 0, z = 0;
  for (Vec3 v : values) x += v.x, y += v.y, z += v.z;
  const auto n = static_cast<double>(values.size());
  return {float(x / n), float(y / n), float(z / n)};
}

float nearest_pair(std::span<const Vec3> points) {
  float nearest = 1e9f;
  for (size_t i = 0; i < points.size(); ++i)
    for (size_t j = 0; j < i; ++j) nearest = std::min(nearest, length(points[i] - points[j]));
  return nearest;
}

class CrowdTest : public OnDevice {
 protected:
  WorldDef floating() const {
    WorldDef def = world_def(GetParam(), s);
    def.gravity = {0, 0, 0};
    def.substeps = def.iterations = 2;
    return def;
  }

  static std::vector<Vec3> heap(size_t count, float spread, Vec3 at) {
    std::mt19937 random(3);
    std::vector<Vec3> points(count, at);
    if (spread > 0)
      for (Vec3& p : points) p += random_vector(random, spread);
    return points;
  }

  static Fastest run_watched(World& world, int steps) {
    Fastest fastest;
    std::vector<Vec3> before = copy(world.positions());
    for (int k = 0; k < steps; ++k) {
      world.step(dt);
      for (size_t i = 0; i < before.size(); ++i) {
        fastest.velocity = std::max(fastest.velocity, length(world.velocities()[i]));
        fastest.moved = std::max(fastest.moved, length(world.positions()[i] - before[i]) / dt);
      }
      before = copy(world.positions());
    }
    return fastest;
  }

  void expect_parted(size_t count, float spread, int steps) {
    World world(floating());
    const std::vector<Vec3> points = heap(count, spread, {0.3f, -0.2f, 0.1f});
    const Vec3 at = mean(points);
    world.add_particles(world.create_fluid({}), points);
    const Fastest fastest = run_watched(world, steps);
    EXPECT_LT(fastest.velocity, parting_speed);
    EXPECT_LT(fastest.moved, 1.01f * parting_speed);
    EXPECT_GT(nearest_pair(world.positions()), 0.15f * s);
    EXPECT_LT(world.diagnostics().density_error_max, 0.05);
    EXPECT_LT(length(mean(world.positions()) - at), 1e-5f);
    EXPECT_LT(length(mean(world.velocities())), 1e-5f);
  }
};

TEST_P(CrowdTest, TwoAtOnePointPart) {
  expect_parted(2, 0, 60);
}

TEST_P(CrowdTest, TenAtOnePointPart) {
  expect_parted(10, 0, 60);
}

TEST_P(CrowdTest, ParticlesAtOnePointPart) {
  expect_parted(400, 0, 90);
}

/// Nothing depends on whether the distance is 0 or nearly so.
TEST_P(CrowdTest, ParticlesAlmostAtOnePointPart) {
  for (const float spread : {1e-7f, 1e-4f, 0.01f}) expect_parted(200, spread, 80);
}

/// The bound of 10,000 holds from the first step on, where the most pairs coincide.
TEST_P(CrowdTest, TenThousandAtOnePointBeginToPart) {
  WorldDef def = floating();
  def.substeps = def.iterations = 1;
  World world(def);
  world.add_particles(world.create_fluid({}), heap(10000, 0, {0.3f, -0.2f, 0.1f}));
  const Fastest fastest = run_watched(world, 3);
  EXPECT_LT(fastest.velocity, 0.01f * parting_speed);
  EXPECT_LT(fastest.moved, 1.01f * parting_speed);
  EXPECT_GT(fastest.moved, 0.1f * parting_speed) << "they stay";
}

/// What is compressed by a crowd joins it, so that the water around is not thrown about.
TEST_P(CrowdTest, InsideAPoolItParts) {
  World world(world_def(GetParam(), s));
  const FluidId water = world.create_fluid({});
  world.create_shape(tank({-0.3f, 0, -0.3f}, {0.3f, 1, 0.3f}));
  world.add_fluid(block(water, {-0.3f, 0, -0.3f}, {0.3f, 0.3f, 0.3f}));
  run(world, 20, dt);
  world.add_particles(water, heap(100, 0, {0, 0.15f, 0}));
  const Fastest fastest = run_watched(world, 60);
  RecordProperty("fastest", std::to_string(fastest.moved));
  EXPECT_LT(fastest.moved, 2 * parting_speed);
  run(world, 90, dt);
  EXPECT_LT(world.diagnostics().density_error_mean, 0.03);
}

TEST_P(CrowdTest, IsTheSameEachTime) {
  const auto hash = [&](int threads) {
    WorldDef def = floating();
    def.threads = threads;
    World world(def);
    world.add_particles(world.create_fluid({}), heap(200, 0, {0.3f, -0.2f, 0.1f}));
    run(world, 10, dt);
    return world.state_hash();
  };
  const uint64_t first = hash(1);
  EXPECT_EQ(hash(1), first);
  if (GetParam() == pbd::DeviceKind::cpu) {
    const ManyThreads allowed;
    for (int threads : {2, 3, 8}) EXPECT_EQ(hash(threads), first) << threads << " threads";
  }
}

TEST_P(CrowdTest, MoreThanTheLimitAreRefused) {
  World world(floating());
  const FluidId water = world.create_fluid({});
  const Vec3 at{0.5f, 0.25f, 2};
  expect_error(ErrorCode::capacity,
               "16385 particles within one support radius (0.1 m) of (0.5, 0.25, 2); at most 16384",
               [&] { world.add_particles(water, heap(16385, 0, at)); });
  EXPECT_EQ(world.particle_count(), 0u);
  world.add_particles(water, heap(16000, 0, at));
  for (int k = 0; k < 3; ++k) world.add_particles(water, heap(128, 0, at));
  expect_error(ErrorCode::capacity, "at most 16384", [&] { world.add_particles(water, heap(1, 0, at)); });
  world.add_particles(water, heap(1, 0, at + Vec3{0.11f, 0, 0}));
  EXPECT_EQ(world.particle_count(), 16385u);
}

MENISCUS_ON_EACH_DEVICE(CrowdTest);

}  // namespace
}  // namespace meniscus::tests
