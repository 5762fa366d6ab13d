// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Viscous flows in whole worlds: decay, rotation, a column of honey, and bodies in it.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

constexpr float pi = 3.14159265f;

class ViscousFlowTest : public OnDevice {
 protected:
  static void set_velocities(World& world, FluidId fluid, const std::vector<Vec3>& wanted) {
    std::vector<Vec3> impulses;
    const float mass = static_cast<float>(world.particle_mass(fluid));
    for (size_t i = 0; i < wanted.size(); ++i) impulses.push_back(mass * (wanted[i] - world.velocities()[i]));
    const std::vector<ParticleId> ids(world.ids().begin(), world.ids().end());
    world.apply_impulses(ids, impulses);
  }

  /// kg m²/s, along y, about the origin.
  static double spin(const World& world, FluidId fluid) {
    double sum = 0;
    for (size_t i = 0; i < world.particle_count(); ++i)
      sum += world.particle_mass(fluid) * double{cross(world.positions()[i], world.velocities()[i]).y};
    return sum;
  }

  /// m: how far honey has spread on a floor that it sticks to, as the RMS distance from the axis.
  static double spread(int substeps, float slip_length = 0) {
    constexpr float s = 0.02f;
    WorldDef def = world_def(GetParam(), s);
    def.substeps = substeps;
    World world(def);
    ShapeDef floor = shape(PlaneGeometry{});
    floor.surface.slip_length = slip_length;
    world.create_shape(floor);
    FluidDef honey;
    honey.rest_density = 1400;
    honey.dynamic_viscosity = 10;
    honey.xsph = 0;
    world.add_fluid(block(world.create_fluid(honey), {-4 * s, 0, -4 * s}, {4 * s, 12 * s, 4 * s}));
    run(world, 45, 1 / 60.0f);
    double sum = 0;
    for (Vec3 p : world.positions()) sum += double{p.x} * p.x + double{p.z} * p.z;
    return std::sqrt(sum / static_cast<double>(world.particle_count()));
  }
};

/// The flow in a square box with free walls decays with 2 ν k². The water is stirred before, so that it is no
/// crystal.
TEST_P(ViscousFlowTest, AVortexInABoxDecaysAtTheAnalyticRate) {
  constexpr float s = 0.05f, length = 1, k = pi / length, viscosity = 50;
  WorldDef def = world_def(GetParam(), s);
  def.gravity = {0, 0, 0};
  World world(def);
  world.create_shape(tank({0, 0, 0}, {length, length, 6 * s}));
  FluidDef fluid;
  fluid.xsph = 0;
  const FluidId id = world.create_fluid(fluid);
  world.add_fluid(block(id, {0, 0, 0}, {length, length, 6 * s}));
  const auto flow = [&](Vec3 x) {
    return Vec3{std::sin(k * x.x) * std::cos(k * x.y), -std::cos(k * x.x) * std::sin(k * x.y), 0};
  };
  const auto set_flow = [&](float speed, float noise) {
    std::mt19937 random(3);
    std::vector<Vec3> velocities;
    for (Vec3 x : world.positions()) velocities.push_back(speed * flow(x) + random_vector(random, noise));
    set_velocities(world, id, velocities);
  };
  set_flow(2, 1);
  run(world, 60, 1 / 60.0f);
  fluid.xsph = 20;
  world.set_fluid(id, fluid);
  run(world, 30, 1 / 60.0f);
  fluid.xsph = 0;
  fluid.dynamic_viscosity = viscosity;
  world.set_fluid(id, fluid);
  set_flow(0.2f, 0);
  const auto amplitude = [&] {
    double along = 0, norm = 0;
    for (size_t i = 0; i < world.particle_count(); ++i) {
      const Vec3 u = flow(world.positions()[i]);
      along += dot(u, world.velocities()[i]);
      norm += dot(u, u);
    }
    return along / norm;
  };
  const double before = amplitude();
  run(world, 30, 1 / 60.0f);
  const double rate = -std::log(amplitude() / before) / 0.5;
  EXPECT_NEAR(rate / (2 * viscosity / 1000 * k * k), 1, 0.08);
}

TEST_P(ViscousFlowTest, ABlobThatTurnsKeepsItsAngularMomentum) {
  for (const float viscosity : {10.0f, 1000.0f}) {
    WorldDef def = world_def(GetParam(), 0.05f);
    def.gravity = {0, 0, 0};
    World world(def);
    FluidDef fluid;
    fluid.xsph = 0;
    fluid.dynamic_viscosity = viscosity;
    const FluidId id = world.create_fluid(fluid);
    FluidVolumeDef ball;
    ball.fluid = id;
    ball.region = BallRegion{0.3f};
    world.add_fluid(ball);
    std::vector<Vec3> velocities;
    for (Vec3 x : world.positions()) velocities.push_back(cross(Vec3{0, 1, 0}, x));
    set_velocities(world, id, velocities);
    const double before = spin(world, id);
    run(world, 60, 1 / 60.0f);
    EXPECT_NEAR(spin(world, id) / before, 1, 1e-3) << viscosity << " Pa·s";
  }
}

TEST_P(ViscousFlowTest, HoneySpreadsAlikeWithAnySubsteps) {
  const double two = spread(2), four = spread(4), eight = spread(8);
  EXPECT_NEAR(two / four, 1, 0.1);
  EXPECT_NEAR(eight / four, 1, 0.1);
  EXPECT_GT(spread(4, std::numeric_limits<float>::infinity()), 1.1 * four);  // it slips
}

/// A ball that spins in a free drop of honey drags it along, and what both have together stays.
TEST_P(ViscousFlowTest, ABodyGetsWhatItsSurfaceExerts) {
  WorldDef def = world_def(GetParam(), 0.05f);
  def.gravity = {0, 0, 0};
  World world(def);
  BodyDef stone;
  stone.geometry = SphereGeometry{0.15f};
  stone.density = 300;
  stone.angular_velocity = {0, 6, 0};
  stone.surface.slip_length = 0;
  const BodyId body = world.create_body(stone);
  FluidDef fluid;
  fluid.xsph = 0;
  fluid.dynamic_viscosity = 100;
  const FluidId id = world.create_fluid(fluid);
  FluidVolumeDef ball;
  ball.fluid = id;
  ball.region = BallRegion{0.35f};
  world.add_fluid(ball);
  const auto momentum = [&] {
    Vec3 sum = world.body_mass(body).mass * world.body_state(body).velocity;
    for (Vec3 v : world.velocities()) sum += static_cast<float>(world.particle_mass(id)) * v;
    return sum;
  };
  const auto spin_of_body = [&] {
    return double{world.body_mass(body).inertia.y} * world.body_state(body).angular_velocity.y;
  };
  const Vec3 before = momentum();
  const float spin_before = world.body_state(body).angular_velocity.y;
  const double both_before = spin_of_body() + spin(world, id);
  run(world, 30, 1 / 60.0f);
  EXPECT_LT(length(momentum() - before), 1e-3f);
  EXPECT_LT(world.body_state(body).angular_velocity.y, 0.5f * spin_before);
  EXPECT_GT(world.body_state(body).angular_velocity.y, -0.01f * spin_before);
  EXPECT_NEAR((spin_of_body() + spin(world, id)) / both_before, 1, 0.02);
}

MENISCUS_ON_EACH_DEVICE(ViscousFlowTest);

}  // namespace
}  // namespace meniscus::tests
