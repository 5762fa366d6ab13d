// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Drops without gravity, against closed forms: they end as balls, and oscillate with Rayleigh's period.
#include "fluid/forces/surface_tension.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

constexpr float frame = 0.016f;

WorldDef weightless(pbd::DeviceKind device, float spacing) {
  WorldDef def = world_def(device, spacing);
  def.gravity = {0, 0, 0};
  return def;
}

FluidDef with_tension(float surface_tension, float cohesion, float xsph) {
  FluidDef def;
  def.surface_tension = surface_tension;
  def.cohesion = cohesion;
  def.xsph = xsph;
  return def;
}

/// Σ (x⁴ + y⁴ + z⁴) / Σ r⁴: 3/5 for a ball, 0.47 for a cube.
double roundness(const World& world) {
  double fourth = 0, all = 0;
  for (Vec3 p : world.positions()) {
    fourth += std::pow(p.x, 4) + std::pow(p.y, 4) + std::pow(p.z, 4);
    all += std::pow(dot(p, p), 2);
  }
  return fourth / all;
}

/// Length over width of something that is round about y.
double elongation(const World& world) {
  double along = 0, across = 0;
  for (Vec3 p : world.positions()) {
    along += p.y * p.y;
    across += 0.5 * (p.x * p.x + p.z * p.z);
  }
  return std::sqrt(along / across);
}

double radius_of(const World& world) {
  double square = 0;
  for (Vec3 p : world.positions()) square += dot(p, p);
  return std::sqrt(square / static_cast<double>(world.particle_count()) * 5 / 3);
}

std::vector<Vec3> ball_points(float radius, float spacing) {
  std::vector<Vec3> points;
  const int n = static_cast<int>(2 * radius / spacing);
  for (Vec3 p : lattice(n, n, n, spacing, {-radius, -radius, -radius})) {
    if (length(p) < radius) points.push_back(p);
  }
  return points;
}

/// The period in which a drop that was stretched swings, over Rayleigh's.
double period_of_drop(World& world) {
  constexpr float sigma = 100, density = 1000;
  std::vector<double> crossings;
  double before = 1.01, radius = 0;
  for (int k = 0; k < 320 && crossings.size() < 3; ++k) {
    world.step(frame);
    const double now = elongation(world);
    if ((before - 1) * (now - 1) < 0) crossings.push_back(world.time() - frame * (now - 1) / (now - before));
    before = now;
    radius = radius_of(world);
  }
  EXPECT_EQ(crossings.size(), 3u);
  if (crossings.size() < 3) return 0;
  const double period = 2 * std::numbers::pi / std::sqrt(8 * sigma / (density * std::pow(radius, 3)));
  return (crossings[2] - crossings[0]) / period;
}

class SurfaceTensionTest : public OnDevice {};

TEST_P(SurfaceTensionTest, ADropSwingsWithRayleighsPeriod) {
  World world(weightless(GetParam(), 0.0625f));
  const std::vector<Vec3> points = ball_points(0.5f, 0.0625f);
  std::vector<Vec3> stretching;
  for (Vec3 p : points) stretching.push_back(0.25f * Vec3{-p.x, 2 * p.y, -p.z});
  world.add_particles(world.create_fluid(with_tension(100, 0, 0.5f)), points, stretching);
  EXPECT_NEAR(period_of_drop(world), 1, 0.08);
}

TEST_P(SurfaceTensionTest, SoDoesADropInDisorderWithEachKernel) {
  for (SmoothingKernel kernel : {SmoothingKernel::wendland_c2, SmoothingKernel::cubic_spline}) {
    WorldDef def = weightless(GetParam(), 0.0625f);
    def.kernel = kernel;
    World world(def);
    const FluidId water = world.create_fluid(with_tension(100, 0, 0.5f));
    world.add_fluid({.fluid = water, .region = BallRegion{0.5f}, .seeding = Seeding::disordered});
    std::vector<Vec3> impulses;
    const float m = 0.25f * world.particle_mass(water);
    for (Vec3 p : world.positions()) impulses.push_back(m * Vec3{-p.x, 2 * p.y, -p.z});
    const std::vector<ParticleId> ids(world.ids().begin(), world.ids().end());
    world.apply_impulses(ids, impulses);
    EXPECT_NEAR(period_of_drop(world), 1, 0.1);
  }
}

TEST_P(SurfaceTensionTest, ACubeBecomesABall) {
  World world(weightless(GetParam(), 0.08f));
  world.add_fluid(
      block(world.create_fluid(with_tension(100, 0, 20)), {-0.4f, -0.4f, -0.4f}, {0.4f, 0.4f, 0.4f}));
  EXPECT_LT(roundness(world), 0.5);
  run(world, 150, frame);
  EXPECT_NEAR(roundness(world), 0.6, 0.015);
}

TEST_P(SurfaceTensionTest, CohesionDrawsDropsTogether) {
  for (float cohesion : {0.0f, 50.0f}) {
    World world(weightless(GetParam(), 0.08f));
    const FluidId fluid = world.create_fluid(with_tension(0, cohesion, 20));
    world.add_fluid(block(fluid, {-0.46f, -0.2f, -0.2f}, {-0.06f, 0.2f, 0.2f}));
    world.add_fluid(block(fluid, {0.06f, -0.2f, -0.2f}, {0.46f, 0.2f, 0.2f}));
    run(world, 60, frame);
    float gap = 1;
    for (Vec3 p : world.positions()) gap = std::min(gap, std::abs(p.x));
    if (cohesion > 0) {
      EXPECT_LT(gap, 0.05f);
    } else {
      EXPECT_GT(gap, 0.08f);
    }
  }
}

TEST_P(SurfaceTensionTest, MomentumIsKeptBetweenFluids) {
  World world(weightless(GetParam(), 0.08f));
  FluidDef heavy = with_tension(80, 10, 5), light = with_tension(20, 0, 5);
  light.rest_density = 300;
  const float masses[] = {1000, 300};
  const FluidId ids[] = {world.create_fluid(heavy), world.create_fluid(light)};
  world.add_fluid(block(ids[0], {-0.4f, -0.2f, -0.2f}, {0, 0.2f, 0.2f}));
  const size_t first = world.particle_count();
  world.add_fluid(block(ids[1], {0, -0.2f, -0.2f}, {0.4f, 0.3f, 0.2f}));
  for (int k = 0; k < 40; ++k) {
    world.step(frame);
    Vec3 momentum{0, 0, 0};
    double size = 0;
    for (size_t i = 0; i < world.particle_count(); ++i) {
      const float mass = masses[i < first ? 0 : 1];
      momentum += mass * world.velocities()[i];
      size += mass * length(world.velocities()[i]);
    }
    ASSERT_LT(length(momentum), 1e-3 * size) << "frame " << k;
  }
}

TEST_P(SurfaceTensionTest, LikeFluidsHaveNoSurfaceBetweenThem) {
  const FluidDef fluid = with_tension(60, 20, 5);
  World one(weightless(GetParam(), 0.08f)), two(weightless(GetParam(), 0.08f));
  const FluidId a = one.create_fluid(fluid), b = two.create_fluid(fluid), c = two.create_fluid(fluid);
  one.add_fluid(block(a, {-0.4f, -0.2f, -0.2f}, {0, 0.2f, 0.2f}));
  one.add_fluid(block(a, {0, -0.2f, -0.2f}, {0.4f, 0.2f, 0.2f}));
  two.add_fluid(block(b, {-0.4f, -0.2f, -0.2f}, {0, 0.2f, 0.2f}));
  two.add_fluid(block(c, {0, -0.2f, -0.2f}, {0.4f, 0.2f, 0.2f}));
  run(one, 10, frame);
  run(two, 10, frame);
  for (size_t i = 0; i < one.particle_count(); ++i) EXPECT_EQ(one.positions()[i], two.positions()[i]);
}

TEST_P(SurfaceTensionTest, APoolStaysOnItsFloor) {
  WorldDef def = world_def(GetParam(), 0.08f);
  World world(def);
  const FluidId water = world.create_fluid(with_tension(30, 10, 50));
  world.create_shape(tank({-0.4f, 0, -0.4f}, {0.4f, 2, 0.4f}));
  world.add_fluid(block(water, {-0.4f, 0, -0.4f}, {0.4f, 0.4f, 0.4f}));
  run(world, 120, frame);
  EXPECT_NEAR(mean_height(world), 0.2, 0.012);
  EXPECT_LT(world.diagnostics().density_error_mean, 0.01);
}

// The surface pulls the floor up where it would leave it: what presses is the weight, and not what attraction
// presses the fluid together with.
TEST_P(SurfaceTensionTest, TheFloorBearsTheWeight) {
  World world(world_def(GetParam(), 0.08f));
  const FluidId water = world.create_fluid(with_tension(30, 10, 50));
  const ShapeId box = world.create_shape(tank({-0.4f, 0, -0.4f}, {0.4f, 2, 0.4f}));
  world.add_fluid(block(water, {-0.4f, 0, -0.4f}, {0.4f, 0.4f, 0.4f}));
  const double force = mean_force_on_floor(world, box, 120, 30, frame);
  const double weight =
      9.81 * double{world.particle_mass(water)} * static_cast<double>(world.particle_count());
  RecordProperty("force_over_weight", std::to_string(force / weight));
  EXPECT_NEAR(force / weight, 1, 0.02);
}

MENISCUS_ON_EACH_DEVICE(SurfaceTensionTest);

TEST(TensionKernel, AttractsFarAndRepelsNear) {
  const float h = 0.2f;
  const fluid::TensionKernel t = fluid::calibrate_tension(fluid::calibrate(0.1, h), 0.1);
  EXPECT_LT(t.attraction(0.1f * h), 0);
  EXPECT_GT(t.attraction(0.5f * h), 0);
  EXPECT_GT(t.attraction(0.9f * h), 0);
  EXPECT_EQ(t.attraction(h), 0);
  EXPECT_EQ(t.attraction(1e15f), 0);
}

TEST(TensionKernel, MeansTheSameAtEverySpacing) {
  const fluid::TensionKernel coarse = fluid::calibrate_tension(fluid::calibrate(0.1, 0.2), 0.1),
                             fine = fluid::calibrate_tension(fluid::calibrate(0.01, 0.02), 0.01);
  EXPECT_NEAR(fine.attraction(0.012f) / coarse.attraction(0.12f), 0.1, 1e-4);
  EXPECT_NEAR(fine.curvature_scale / coarse.curvature_scale, 0.1, 1e-4);
}

}  // namespace
}  // namespace meniscus::tests
