// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the ellipsoids that represent particles at the surface.
#include "fluid/surface/anisotropy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "fluid/surface/principal_axes.h"
#include "tests/many_threads.h"
#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

constexpr float s = 0.05f;

float least(Vec3 v) {
  return std::min({v.x, v.y, v.z});
}

/// How far the ellipsoid reaches along a unit vector.
float reach(const Ellipsoid& e, Vec3 direction) {
  const Vec3 d = rotate(conjugate(e.rotation), direction);
  return length({e.radii.x * d.x, e.radii.y * d.y, e.radii.z * d.z});
}

std::vector<Vec3> turned(std::vector<Vec3> points, Quat q) {
  for (Vec3& p : points) p = rotate(q, p);
  return points;
}

class AnisotropyTest : public OnDevice {
 protected:
  World world_of(std::span<const Vec3> points) const {
    World world(world_def(GetParam(), s));
    world.add_particles(world.create_fluid({}), points);
    return world;
  }
};

TEST_P(AnisotropyTest, ALoneParticleIsABallOfItsVolume) {
  const Vec3 at[] = {{1, 2, 3}};
  const World world = world_of(at);
  const Ellipsoid e = world.ellipsoids()[0];
  EXPECT_EQ(e.centre, at[0]);
  for (float r : {e.radii.x, e.radii.y, e.radii.z})
    EXPECT_NEAR(4.0 / 3 * std::numbers::pi * r * r * r / (s * s * s), 1, 1e-4);
}

TEST_P(AnisotropyTest, AGrainIsTheBallThatItIsAmongWhateverNeighbours) {
  World world(world_def(GetParam(), s));
  world.add_particles(world.create_fluid({}), lattice(4, 4, 4, s, {0, 0, 0}));
  world.add_particles(world.create_granular({}), lattice(4, 2, 4, s, {0, 4 * s, 0}));
  const std::span<const Ellipsoid> ellipsoids = world.ellipsoids();
  for (std::size_t i = 64; i < 96; ++i) {
    EXPECT_EQ(ellipsoids[i].centre, world.positions()[i]);
    EXPECT_EQ(ellipsoids[i].radii, (Vec3{0.5f * s, 0.5f * s, 0.5f * s}));
  }
  EXPECT_NE(ellipsoids[63].centre, world.positions()[63]);
}

TEST_P(AnisotropyTest, InsideItIsABall) {
  const World world = world_of(lattice(9, 9, 9, s, {0, 0, 0}));
  const Ellipsoid e = world.ellipsoids()[4 * 81 + 4 * 9 + 4];
  EXPECT_LT(length(e.centre - world.positions()[4 * 81 + 4 * 9 + 4]), 1e-4f * s);
  EXPECT_NEAR(max_component(e.radii) / least(e.radii), 1, 1e-3);
}

TEST_P(AnisotropyTest, ASheetIsFlatHoweverItIsTurned) {
  const Quat turn = normalized({0.3f, -0.5f, 0.2f, 0.7f});
  const Vec3 normal = rotate(turn, {0, 1, 0});
  const World world = world_of(turned(lattice(9, 1, 9, s, {0, 0, 0}), turn));
  const Ellipsoid e = world.ellipsoids()[40];
  EXPECT_NEAR(max_component(e.radii) / least(e.radii), 4, 1e-3) << "as flat as may be";
  EXPECT_NEAR(reach(e, normal), least(e.radii), 1e-3f * s);
  EXPECT_NEAR(reach(e, rotate(turn, {1, 0, 0})), max_component(e.radii), 0.02f * s);
  // About as thick as the water that it stands for.
  EXPECT_NEAR(2 * reach(e, normal) / s, 1, 0.2);
}

TEST_P(AnisotropyTest, TheSurfaceOfAPoolIsHalfASpacingAboveItsTopParticles) {
  const World world = world_of(lattice(12, 8, 12, s, {0, 0, 0}));
  float top = 0;
  for (std::size_t i = 0; i < world.particle_count(); ++i) {
    const Vec3 p = world.positions()[i];
    const bool is_inner = std::abs(p.x - 6 * s) < 2.6f * s && std::abs(p.z - 6 * s) < 2.6f * s;
    if (is_inner)
      top = std::max(top, world.ellipsoids()[i].centre.y + reach(world.ellipsoids()[i], {0, 1, 0}));
  }
  EXPECT_NEAR(top / s, 8, 0.01);
}

TEST_P(AnisotropyTest, MoreNeighboursChangeTheSizeStepByStep) {
  // A drop that comes nearer to a pool, a hundredth of a spacing at a time.
  float before = 0;
  for (int k = 0; k <= 150; ++k) {
    std::vector<Vec3> points = lattice(7, 4, 7, s, {0, 0, 0});
    points.push_back({3.5f * s, (6.0f - 0.01f * float(k)) * s, 3.5f * s});
    const World world = world_of(points);
    const float radius = cbrtf(world.ellipsoids().back().radii.x * world.ellipsoids().back().radii.y *
                               world.ellipsoids().back().radii.z);
    if (k > 0) {
      EXPECT_LT(std::abs(radius - before), 0.05f * s) << "at step " << k;
    }
    before = radius;
  }
}

TEST_P(AnisotropyTest, TheReadOutIsInTheOrderOfIdsAndLeavesTheStateAsItIs) {
  World world = dam_break(GetParam());
  run(world, 10, 0.016f);
  const uint64_t hash = world.state_hash();
  ASSERT_EQ(world.ellipsoids().size(), world.particle_count());
  for (std::size_t i = 0; i < world.particle_count(); ++i)
    EXPECT_LT(length(world.ellipsoids()[i].centre - world.positions()[i]),
              1.2f * world.def().particle_spacing);
  EXPECT_EQ(world.state_hash(), hash);
  World other = dam_break(GetParam());
  run(other, 10, 0.016f);
  run(world, 3, 0.016f);
  run(other, 3, 0.016f);
  EXPECT_EQ(world.state_hash(), other.state_hash()) << "a look at it has changed what comes after";
}

TEST_P(AnisotropyTest, EveryNumberOfThreadsGivesTheSameBits) {
  if (GetParam() != pbd::DeviceKind::cpu) GTEST_SKIP() << "threads are the CPU's";
  const ManyThreads many;
  std::vector<Ellipsoid> first;
  for (int threads : {1, 8}) {
    WorldDef def = world_def(GetParam(), s);
    def.threads = threads;
    World world = dam_break(def);
    run(world, 5, 0.016f);
    const std::vector<Ellipsoid> now(world.ellipsoids().begin(), world.ellipsoids().end());
    if (first.empty()) first = now;
    ASSERT_EQ(first.size(), now.size());
    EXPECT_EQ(std::memcmp(first.data(), now.data(), now.size() * sizeof now[0]), 0);
  }
}

MENISCUS_ON_EACH_DEVICE(AnisotropyTest);

TEST(PrincipalAxes, MakeUpTheMatrixAgain) {
  std::mt19937 random(3);
  for (int k = 0; k < 1000; ++k) {
    const Vec3 d = random_vector(random, 1), o = random_vector(random, k % 2 ? 1.0f : 1e-4f);
    const fluid::PrincipalAxes a = fluid::principal_axes({d.x, d.y, d.z, o.x, o.y, o.z});
    const Vec3 axes[] = {rotate(a.rotation, {1, 0, 0}), rotate(a.rotation, {0, 1, 0}),
                         rotate(a.rotation, {0, 0, 1})};
    const float values[] = {a.values.x, a.values.y, a.values.z};
    fluid::Symmetric3 m{0, 0, 0, 0, 0, 0};
    for (int i = 0; i < 3; ++i) {
      m.xx += values[i] * axes[i].x * axes[i].x;
      m.yy += values[i] * axes[i].y * axes[i].y;
      m.zz += values[i] * axes[i].z * axes[i].z;
      m.xy += values[i] * axes[i].x * axes[i].y;
      m.xz += values[i] * axes[i].x * axes[i].z;
      m.yz += values[i] * axes[i].y * axes[i].z;
    }
    EXPECT_NEAR(m.xx, d.x, 3e-6);
    EXPECT_NEAR(m.yy, d.y, 3e-6);
    EXPECT_NEAR(m.zz, d.z, 3e-6);
    EXPECT_NEAR(m.xy, o.x, 3e-6);
    EXPECT_NEAR(m.xz, o.y, 3e-6);
    EXPECT_NEAR(m.yz, o.z, 3e-6);
  }
}

TEST(PrincipalAxes, OfNothingAreAnyAxes) {
  const fluid::PrincipalAxes a = fluid::principal_axes({0, 0, 0, 0, 0, 0});
  EXPECT_EQ(a.values, (Vec3{0, 0, 0}));
  EXPECT_EQ(a.rotation.w, 1);
}

}  // namespace
}  // namespace meniscus::tests
