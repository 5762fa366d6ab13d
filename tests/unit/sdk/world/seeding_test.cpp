// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Seeding in disorder: the volume, the density, walls and bodies, and what was there before.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

constexpr float s = 0.05f;

FluidVolumeDef disordered(FluidId fluid, const Region& region) {
  FluidVolumeDef def;
  def.fluid = fluid;
  def.region = region;
  def.seeding = Seeding::disordered;
  return def;
}

/// |Σ exp(2πi x/s)| / N along the axis on which the particles in a box are in the best order. A lattice
/// has 1.
double order(const World& world, Vec3 lower, Vec3 upper) {
  double most = 0;
  for (int axis = 0; axis < 3; ++axis) {
    std::complex<double> sum = 0;
    double count = 0;
    for (Vec3 p : world.positions()) {
      if (min(p, lower) != lower || max(p, upper) != upper) continue;
      const double x = axis == 0 ? p.x : axis == 1 ? p.y : p.z;
      sum += std::polar(1.0, 2 * std::numbers::pi * x / s);
      ++count;
    }
    most = std::max(most, std::abs(sum) / count);
  }
  return most;
}

float nearest_pair(const World& world) {
  const std::span<const Vec3> x = world.positions();
  float least = 1;
  for (size_t i = 0; i < x.size(); ++i) {
    for (size_t j = 0; j < i; ++j) least = std::min(least, length(x[i] - x[j]));
  }
  return least;
}

class SeedingTest : public OnDevice {
 protected:
  WorldDef def_ = world_def(GetParam(), s);
};

TEST_P(SeedingTest, DisorderHasTheVolumeOfItsRegion) {
  World world(def_);
  const FluidId water = world.create_fluid({});
  const float s3 = s * s * s;
  const size_t box = world.add_fluid(disordered(water, BoxRegion{{0, 0, 0}, {0.63f, 0.58f, 0.71f}}));
  EXPECT_NEAR(double(box) * s3 / (0.63 * 0.58 * 0.71), 1, 1e-3);
  FluidVolumeDef ball = disordered(water, BallRegion{0.4f});
  ball.pose.position = {2, 0, 0};
  EXPECT_NEAR(double(world.add_fluid(ball)) * s3 / (4.0 / 3 * std::numbers::pi * 0.064), 1, 1e-3);
  EXPECT_EQ(world.add_fluid(disordered(water, BoxRegion{{5, 0, 0}, {5.03f, 1, 1}})), 0u);
}

TEST_P(SeedingTest, DisorderHasTheRestDensity) {
  for (SmoothingKernel kernel : {SmoothingKernel::poly6_spiky, SmoothingKernel::wendland_c2}) {
    def_.kernel = kernel;
    World world(def_);
    world.create_shape(tank({0, 0, 0}, {0.5f, 1, 0.5f}));
    EXPECT_EQ(world.add_fluid(disordered(world.create_fluid({}), BoxRegion{{0, 0, 0}, {0.5f, 0.5f, 0.5f}})),
              1000u);
    EXPECT_LT(order(world, {0.1f, 0.1f, 0.1f}, {0.4f, 0.4f, 0.4f}), 0.5);  // walls order what is beside them
    EXPECT_GT(nearest_pair(world), 0.5f * s);
    EXPECT_LT(world.diagnostics().density_error_mean, 1e-3);
    EXPECT_LT(world.diagnostics().density_error_interior, 0.02);
  }
}

TEST_P(SeedingTest, DisorderIsSafeAtWallsAndBodies) {
  World world(def_);
  world.create_shape(tank({0, 0, 0}, {0.6f, 1, 0.6f}));
  world.create_shape(shape(SphereGeometry{0.15f}, {0.3f, 0.25f, 0.3f}));
  BodyDef body;
  body.geometry = BoxGeometry{{0.08f, 0.08f, 0.08f}};
  body.pose.position = {0.12f, 0.4f, 0.12f};
  world.create_body(body);
  const size_t count =
      world.add_fluid(disordered(world.create_fluid({}), BoxRegion{{-0.1f, 0, -0.1f}, {0.7f, 0.6f, 0.7f}}));
  const double volume = 0.6 * 0.6 * 0.6 - 4.0 / 3 * std::numbers::pi * std::pow(0.15, 3) - std::pow(0.16, 3);
  EXPECT_NEAR(double(count) * s * s * s / volume, 1, 0.02);  // cells of half a spacing make the solids up
  for (Vec3 p : world.positions()) {
    EXPECT_GT(std::min({p.x, p.y, p.z, 0.6f - p.x, 0.6f - p.z}), 0.45f * s);
    EXPECT_GT(length(p - Vec3{0.3f, 0.25f, 0.3f}), 0.15f + 0.45f * s);
    const Vec3 d = p - body.pose.position;
    const auto beyond = [](float x) { return std::max(std::fabs(x) - 0.08f, 0.0f); };
    EXPECT_GT(length(Vec3{beyond(d.x), beyond(d.y), beyond(d.z)}), 0.45f * s);
  }
  EXPECT_EQ(world.diagnostics().outside, 0u);
  EXPECT_LT(world.step(0.004f).max_speed, 0.5f);  // nothing is thrown about
}

TEST_P(SeedingTest, DisorderIsTheSameEachTimeAndForAnyThreads) {
  const auto hash = [&](int threads) {
    def_.threads = threads;
    World world(def_);
    world.create_shape(tank({0, 0, 0}, {0.4f, 0.4f, 0.4f}));
    world.add_fluid(disordered(world.create_fluid({}), BoxRegion{{0, 0, 0}, {0.4f, 0.3f, 0.4f}}));
    return world.state_hash();
  };
  const uint64_t one = hash(1);
  EXPECT_EQ(hash(1), one);
  EXPECT_EQ(hash(3), one);
}

TEST_P(SeedingTest, DisorderLeavesOthersAsTheyAre) {
  World world(def_);
  const FluidId water = world.create_fluid({});
  world.add_fluid(
      {.fluid = water, .region = BoxRegion{{0, 0, 0}, {0.3f, 0.3f, 0.3f}}, .velocity = {0, 1, 0}});
  const std::vector<Vec3> before(world.positions().begin(), world.positions().end());
  FluidVolumeDef beside = disordered(water, BoxRegion{{0.1f, 0, 0}, {0.6f, 0.3f, 0.3f}});
  beside.velocity = {2, 0, 0};
  const size_t added = world.add_fluid(beside);
  EXPECT_NEAR(double(added), 6 * 6 * 6, 12);
  for (size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(world.positions()[i], before[i]);
    EXPECT_EQ(world.velocities()[i], (Vec3{0, 1, 0}));
  }
  EXPECT_EQ(world.velocities()[before.size()], (Vec3{2, 0, 0}));
}

TEST_P(SeedingTest, GrainsRefuseIt) {
  World world(def_);
  const FluidId sand = world.create_granular({});
  try {
    world.add_fluid(disordered(sand, BoxRegion{{0, 0, 0}, {1, 1, 1}}));
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
    EXPECT_NE(std::string(error.what()).find("seeding"), std::string::npos);
  }
  EXPECT_EQ(world.particle_count(), 0u);
}

MENISCUS_ON_EACH_DEVICE(SeedingTest);

}  // namespace
}  // namespace meniscus::tests
