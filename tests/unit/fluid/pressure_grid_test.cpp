// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The pressure grid in small worlds: what depth does to the density, what reaches the floor and what floats,
// and that it makes no momentum.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/coupling/body_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float spacing = 0.05f, frame = 1.0f / 60;

class PressureGridTest : public OnDevice {
 protected:
  static WorldDef def(DensitySolver solver, int substeps = 1) {
    WorldDef d = world_def(GetParam(), spacing);
    d.density.solver = solver;
    d.substeps = substeps;
    d.iterations = 4;
    return d;
  }

  /// A column of 8 × 8 particles, in a tank that begins at `corner`, for a second.
  static World column(DensitySolver solver, int layers, Vec3 corner) {
    World world(def(solver));
    const float width = 8 * spacing, height = float(layers) * spacing;
    world.create_shape(tank(corner, corner + Vec3{width, 2 * height, width}));
    world.add_particles(world.create_fluid({}), lattice(8, layers, 8, spacing, corner), {});
    run(world, 60, frame);
    return world;
  }

  struct Compression {
    double mean, bottom, worst;
  };

  /// ρ/ρ₀ without the two top layers, in the bottom fifth, and the greatest.
  static Compression compression(const World& world) {
    const std::span<const Vec3> at = world.positions();
    const std::span<const float> errors = world.density_errors();
    std::vector<size_t> order(at.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return at[a].y < at[b].y; });
    const auto mean_of = [&](size_t count) {
      double sum = 0;
      for (size_t k = 0; k < count; ++k) sum += double{errors[order[k]]};
      return 1 + sum / static_cast<double>(count);
    };
    return {mean_of(at.size() - 128), mean_of(at.size() / 5),
            1 + double{*std::max_element(errors.begin(), errors.end())}};
  }

  static void expect_at_density(const World& world) {
    const Compression found = compression(world);
    EXPECT_NEAR(found.mean, 1, 0.004);
    EXPECT_NEAR(found.bottom, 1, 0.006);
    EXPECT_LT(found.worst, 1.03);
    EXPECT_EQ(world.diagnostics().outside, 0u);
  }
};

TEST_P(PressureGridTest, HoldsAColumnThatIterationsAloneDoNot) {
  const World world = column(DensitySolver::grid, 30, {0, 0, 0});
  expect_at_density(world);
  EXPECT_GT(compression(column(DensitySolver::chebyshev, 30, {0, 0, 0})).mean, 1.02);
}

// Nodes stand where the world's origin says, and walls do not.
TEST_P(PressureGridTest, WallsMayStandAnywhereAmongTheNodes) {
  for (float shift : {0.2f, 0.45f, 0.5f, 0.7f}) {
    SCOPED_TRACE(shift);
    const float at = shift * 2 * spacing;
    expect_at_density(column(DensitySolver::grid, 10, {at, 0.6f * at, -at}));
  }
}

// In the last half second the floor's mean force is the weight, and pressures are those of hydrostatics.
TEST_P(PressureGridTest, TheFloorBearsTheWeight) {
  World world(def(DensitySolver::grid));
  const float side = 10 * spacing, depth = 16 * spacing;
  const ShapeId box = world.create_shape(tank({0, 0, 0}, {side, 2 * depth, side}));
  world.add_particles(world.create_fluid({}), lattice(10, 16, 10, spacing, {0, 0, 0}), {});
  const double force = mean_force_on_floor(world, box, 60, 30, frame);
  const double weight = 9.81 * 1000 * double{side} * double{side} * double{depth};
  EXPECT_NEAR(force / weight, 1, 0.02);
  double error = 0;
  int counted = 0;
  for (size_t i = 0; i < world.particle_count(); ++i) {
    const double deep = double{depth} - double{world.positions()[i].y};
    if (deep < 0.3 * double{depth}) continue;
    error += double{world.pressures()[i]} / (9810 * deep) - 1;
    ++counted;
  }
  EXPECT_NEAR(error / counted, 0, 0.05);
}

// Two balls of fluids of different density meet without gravity.
// With so many particles in a layer of cells, the table of cells has the order of strips.
TEST_P(PressureGridTest, AWideBlockStartsFromRest) {
  World world(def(DensitySolver::grid));
  const float width = 140 * spacing, depth = 4 * spacing;
  world.create_shape(tank({0, 0, 0}, {2 * width, 2 * width, depth}));
  world.add_fluid(block(world.create_fluid({}), {0, 0, 0}, {width, width, depth}));
  world.step(0.001f);
  EXPECT_LT(world.diagnostics().max_speed, 0.1f);
}

// Their extent has more cells than a table for so few particles.
TEST_P(PressureGridTest, ColumnsFarApartDoNotMeet) {
  constexpr int layers = 60;
  const float width = 8 * spacing, height = layers * spacing;
  World world(def(DensitySolver::grid));
  const FluidId water = world.create_fluid({});
  for (const float x : {0.0f, 12.95f}) {
    const Vec3 corner{x, 0, 0};
    ShapeDef vessel = tank(corner, corner + Vec3{width, 2 * height, width});
    vessel.filter = {x > 0 ? 2u : 1u, x > 0 ? 2u : 1u};
    world.create_shape(vessel);
    FluidDef own;
    own.filter = vessel.filter;
    world.add_particles(x > 0 ? world.create_fluid(own) : water, lattice(8, layers, 8, spacing, corner), {});
  }
  run(world, 60, frame);
  EXPECT_LT(world.diagnostics().density_error_mean, 0.004f);
  EXPECT_LT(world.diagnostics().density_error_max, 0.03f);
}

// A block with errors of its own, as that of a lattice at its corners, does not burst in the first substep.
TEST_P(PressureGridTest, ErrorsOfNewParticlesAreCorrectedAtARate) {
  float speed[2] = {0, 0};
  for (const bool is_short : {false, true}) {
    World world(def(DensitySolver::grid));
    world.create_shape(tank({0, 0, 0}, {2, 2, 0.42f}));
    world.add_fluid(block(world.create_fluid({}), {0, 0, 0}, {0.5f, 0.5f, 0.42f}));
    world.step(is_short ? 0.0001f : 0.001f);
    speed[is_short] = world.diagnostics().max_speed;
  }
  EXPECT_LT(speed[0], 1);
  EXPECT_LT(speed[1], 1);
}

TEST_P(PressureGridTest, InTheOpenNoMomentumIsMade) {
  WorldDef d = def(DensitySolver::grid, 2);
  d.gravity = {0, 0, 0};
  World world(d);
  FluidDef light;
  light.rest_density = 300;
  light.xsph = 0;
  FluidDef heavy = light;
  heavy.rest_density = 1000;
  const std::vector<Vec3> left = lattice(8, 8, 8, spacing, {-0.41f, 0, 0});
  const std::vector<Vec3> right = lattice(8, 8, 8, spacing, {0.01f, 0.07f, 0.03f});
  world.add_particles(world.create_fluid(light), left, std::vector<Vec3>(left.size(), {1, 0, 0}));
  world.add_particles(world.create_fluid(heavy), right, std::vector<Vec3>(right.size(), {-1, 0, 0}));
  // In masses of 512 light particles times m/s.
  const auto momentum = [&](auto component) {
    double sum = 0;
    for (size_t i = 0; i < world.particle_count(); ++i)
      sum += double{component(world.velocities()[i])} * (i < 512 ? 300 : 1000) / (512 * 300);
    return sum;
  };
  run(world, 30, frame);
  EXPECT_NEAR(momentum([](Vec3 v) { return v.x; }), 1 - 1000.0 / 300, 2e-5);
  EXPECT_NEAR(momentum([](Vec3 v) { return v.y; }), 0, 2e-5);
  EXPECT_NEAR(momentum([](Vec3 v) { return v.z; }), 0, 2e-5);
}

TEST_P(PressureGridTest, ABoxFloatsAsDeepAsItsDensitySays) {
  World world(def(DensitySolver::grid, 2));
  const float half = 6 * spacing, depth = 10 * spacing, edge = 6 * spacing;
  world.create_shape(tank({-half, 0, -half}, {half, 3 * depth, half}));
  FluidDef water;
  water.xsph = 50;
  const BodyId box = world.create_body(body(BoxGeometry{{edge / 2, edge / 2, edge / 2}}, {0, depth, 0}, 500));
  world.add_fluid(block(world.create_fluid(water), {-half, 0, -half}, {half, depth, half}));
  const double fluid_volume =
      double{spacing * spacing * spacing} * static_cast<double>(world.particle_count());
  run(world, 150, frame);
  // The level that the fluid and the box's lower half make together.
  const double area = 4 * double{half} * double{half}, base = double{edge} * double{edge};
  const double level = (fluid_volume + 0.5 * base * double{edge}) / area;
  const BodyState state = world.body_state(box);
  EXPECT_NEAR(state.pose.position.y, level, 0.035 * double{edge});
  EXPECT_LT(length(state.velocity), 0.05f);
  EXPECT_EQ(world.diagnostics().outside, 0u);
}

TEST_P(PressureGridTest, EachRunGivesTheSameBits) {
  uint64_t hashes[2];
  for (int k = 0; k < 2; ++k) {
    WorldDef d = def(DensitySolver::grid);
    d.threads = 1 + 2 * k;
    World world = dam_break(d);
    run(world, 20, frame);
    hashes[k] = world.state_hash();
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

MENISCUS_ON_EACH_DEVICE(PressureGridTest);

}  // namespace
}  // namespace meniscus::tests
