// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Worlds that repeat themselves: what crosses a seam, an edge or a corner is as in the middle.
#include <gtest/gtest.h>

#include <cmath>

#include "pbd/math/periodic_axes.h"
#include "tests/expect_error.h"
#include "tests/many_threads.h"
#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

constexpr float s = 0.05f;

/// Extents of 8 to 10 spacings, from -0.25, along the axes of the mask x = 1, y = 2, z = 4.
constexpr Vec3 low{-0.25f, -0.25f, -0.25f}, extent{0.5f, 0.4f, 0.4f};

WorldDef periodic_def(pbd::DeviceKind device, unsigned axes) {
  WorldDef def = world_def(device, s);
  def.gravity = {0, 0, 0};
  if (axes & 1) def.periodic.x = {low.x, low.x + extent.x};
  if (axes & 2) def.periodic.y = {low.y, low.y + extent.y};
  if (axes & 4) def.periodic.z = {low.z, low.z + extent.z};
  return def;
}

pbd::PeriodicAxes all_axes() {
  return {low, extent};
}

/// Water that is stirred, and shifted by a vector around the axes.
struct Shifted {
  World world;
  FluidId fluid;

  Shifted(const WorldDef& def, const FluidDef& water, Vec3 shift)
      : world(def), fluid(world.create_fluid(water)) {
    std::mt19937 random(5);
    std::vector<Vec3> positions, velocities;
    for (Vec3 p : lattice(10, 8, 8, s, low)) {
      Vec3 q = p + random_vector(random, 0.2f * s) + shift;
      q += all_axes().wrap(q);
      positions.push_back(q);
      velocities.push_back(random_vector(random, 0.5f));
    }
    world.add_particles(fluid, positions, velocities);
  }
};

/// m, the greatest distance of a particle from where the other world has it, shifted.
float difference(const World& a, const World& b, Vec3 shift) {
  float most = 0;
  for (size_t i = 0; i < a.particle_count(); ++i)
    most = std::max(most, length(all_axes().nearest(a.positions()[i] + shift - b.positions()[i])));
  return most;
}

Vec3 momentum(const World& world) {
  double sum[3] = {};
  for (Vec3 v : world.velocities()) {
    sum[0] += v.x;
    sum[1] += v.y;
    sum[2] += v.z;
  }
  return {float(sum[0]), float(sum[1]), float(sum[2])};
}

FluidDef busy_fluid() {
  FluidDef water;
  water.dynamic_viscosity = 2;
  water.vorticity_confinement = 0.2f;
  water.surface_tension = 0.5f;
  return water;
}

class PeriodicTest : public OnDevice {};

TEST_P(PeriodicTest, AShiftByHalfAnExtentChangesNothing) {
  WorldDef def = periodic_def(GetParam(), 7);
  def.gravity = {1, -2, 0.5f};
  def.density.artificial_pressure.strength = 0.05f;
  for (const Vec3 shift : {Vec3{0.25f, 0, 0}, Vec3{0, 0.2f, 0.2f}, Vec3{0.25f, 0.2f, 0.2f}}) {
    Shifted a(def, busy_fluid(), {0, 0, 0}), b(def, busy_fluid(), shift);
    run(a.world, 5, 0.016f);
    run(b.world, 5, 0.016f);
    EXPECT_LT(difference(a.world, b.world, shift), 1e-3f * s) << shift.x << ", " << shift.y;
    double error = 0;
    for (size_t i = 0; i < a.world.particle_count(); ++i)
      error = std::max(error, std::fabs(double{a.world.density_errors()[i]} - b.world.density_errors()[i]));
    EXPECT_LT(error, 1e-3);
  }
}

TEST_P(PeriodicTest, TwoFluidsOfDifferentViscosityMeetAcrossTheSeam) {
  const WorldDef def = periodic_def(GetParam(), 7);
  const Vec3 shift{0.25f, 0.2f, 0.2f};
  const auto make = [&](Vec3 by) {
    World world(def);
    FluidDef first, second;
    first.dynamic_viscosity = 50;
    second.rest_density = 400;
    second.xsph = 20;
    const FluidId fluids[] = {world.create_fluid(first), world.create_fluid(second)};
    std::mt19937 random(5);
    for (const FluidId fluid : fluids) {
      std::vector<Vec3> positions, velocities;
      for (Vec3 p : lattice(5, 8, 8, s, low + Vec3{fluid == fluids[0] ? 0.0f : 0.25f, 0, 0})) {
        const Vec3 q = p + by;
        positions.push_back(q + all_axes().wrap(q));
        velocities.push_back(random_vector(random, 0.5f));
      }
      world.add_particles(fluid, positions, velocities);
    }
    run(world, 5, 0.016f);
    return world;
  };
  EXPECT_LT(difference(make({0, 0, 0}), make(shift), shift), 1e-3f * s);
}

TEST_P(PeriodicTest, ASolidAtASeamActsAtBothEnds) {
  const WorldDef def = periodic_def(GetParam(), 7);
  const Vec3 shift{0.25f, 0.2f, 0};
  const auto make = [&](Vec3 by) {
    World world(def);
    const Vec3 centre = Vec3{0, -0.05f, -0.05f} + by;
    world.create_shape(shape(SphereGeometry{0.08f}, centre + all_axes().wrap(centre)));
    std::vector<Vec3> positions;
    for (Vec3 p : lattice(10, 8, 8, s, low)) {
      if (length(all_axes().nearest(p + by - centre)) < 0.08f + s) continue;
      const Vec3 q = p + by;
      positions.push_back(q + all_axes().wrap(q));
    }
    world.add_particles(world.create_fluid({}), positions, std::vector<Vec3>(positions.size(), {1, 0.5f, 0}));
    run(world, 6, 0.016f);
    return world;
  };
  const World middle = make({0, 0, 0}), seam = make(shift);
  EXPECT_LT(difference(middle, seam, shift), 1e-3f * s);
  EXPECT_GT(length(momentum(middle)), 0);
  for (Vec3 p : seam.positions())
    EXPECT_GT(length(all_axes().nearest(p - Vec3{0.25f, 0.15f, -0.05f})), 0.08f);
}

TEST_P(PeriodicTest, MomentumAndParticlesAreKept) {
  FluidDef fluid = busy_fluid();
  fluid.vorticity_confinement = 0;  // it is no force between pairs
  for (const unsigned axes : {1u, 6u, 7u}) {
    Shifted water(periodic_def(GetParam(), axes), fluid, {0, 0, 0});
    const Vec3 before = momentum(water.world);
    double magnitude = 0;
    for (Vec3 v : water.world.velocities()) magnitude += length(v);
    run(water.world, 20, 0.016f);
    EXPECT_EQ(water.world.particle_count(), 640u);
    EXPECT_LT(length(momentum(water.world) - before), 1e-6 * magnitude) << axes;
    const auto is_inside = [&](unsigned axis, float x, float from, float length) {
      return (axes & axis) == 0 || (x >= from && x <= from + length);
    };
    for (Vec3 p : water.world.positions()) {
      EXPECT_TRUE(is_inside(1, p.x, low.x, extent.x)) << p.x;
      EXPECT_TRUE(is_inside(2, p.y, low.y, extent.y)) << p.y;
      EXPECT_TRUE(is_inside(4, p.z, low.z, extent.z)) << p.z;
    }
  }
}

/// A pair that overlaps across a seam, an edge or a corner parts as in the middle.
TEST_P(PeriodicTest, PairsPartAcrossSeamsEdgesAndCorners) {
  const auto parted = [&](Vec3 at, unsigned axes, Vec3 direction) {
    World world(periodic_def(GetParam(), axes));
    const pbd::PeriodicAxes ends{low,
                                 {axes & 1 ? extent.x : 0, axes & 2 ? extent.y : 0, axes & 4 ? extent.z : 0}};
    std::vector<Vec3> pair{at + 0.3f * s * direction, at - 0.3f * s * direction};
    for (Vec3& p : pair) p += ends.wrap(p);
    world.add_particles(world.create_fluid({}), pair, std::vector<Vec3>{-1 * direction, direction});
    run(world, 2, 0.01f);
    return world.velocities()[0];
  };
  const float d = std::sqrt(1 / 3.0f);
  const Vec3 diagonal{d, d, d};
  const Vec3 expected = parted({0, 0, 0}, 0, diagonal);
  EXPECT_LT(length(expected), 0.98f);  // they have met
  EXPECT_LT(length(parted({low.x, 0, 0}, 1, diagonal) - expected), 1e-4f);
  EXPECT_LT(length(parted({low.x, low.y, 0}, 3, diagonal) - expected), 1e-4f);
  EXPECT_LT(length(parted({0, low.y, low.z}, 6, diagonal) - expected), 1e-4f);
  EXPECT_LT(length(parted(low, 7, diagonal) - expected), 1e-4f);
}

TEST_P(PeriodicTest, AParticleFliesAroundForEver) {
  World world(periodic_def(GetParam(), 7));
  const Vec3 start{0.1f, 0, -0.2f}, speed{7, -3, 11};
  world.add_particles(world.create_fluid({}), std::vector<Vec3>{start}, std::vector<Vec3>{speed});
  run(world, 40, 0.016f);
  EXPECT_LT(length(all_axes().nearest(world.positions()[0] - (start + 0.64f * speed))), 1e-4f);
  EXPECT_LT(length(world.velocities()[0] - speed), 1e-5f);
}

/// A block of water in a corner has far more ghosts than water that is spread evenly. Placed too dense, it is
/// a crowd, which parts.
TEST_P(PeriodicTest, ACrowdInACornerGetsRoomForItsGhosts) {
  WorldDef def = world_def(GetParam(), s);
  def.periodic = {PeriodicExtent{0, 4}, PeriodicExtent{0, 4}, PeriodicExtent{0, 4}};
  const pbd::PeriodicAxes axes{{0, 0, 0}, {4, 4, 4}};
  for (const float part : {0.9f, 0.6f}) {
    const auto block_around = [&](Vec3 centre) {
      World world(def);
      std::vector<Vec3> positions;
      for (Vec3 p : lattice(8, 8, 8, part * s, -4 * part * Vec3{s, s, s})) {
        const Vec3 q = p + centre;
        positions.push_back(q + axes.wrap(q));
      }
      world.add_particles(world.create_fluid({}), positions);
      world.density_errors();  // measures before any step
      run(world, 3, 0.01f);
      std::vector<Vec3> relative;
      for (Vec3 p : world.positions()) relative.push_back(axes.nearest(p - centre));
      return relative;
    };
    const std::vector<Vec3> middle = block_around({2, 2, 2}), corner = block_around({0, 0, 0});
    for (size_t i = 0; i < middle.size(); ++i) EXPECT_LT(length(middle[i] - corner[i]), 1e-4f);
  }
}

TEST_P(PeriodicTest, ThreadsDoNotMatter) {
  const ManyThreads allowed;
  uint64_t hashes[2];
  for (int k = 0; k < 2; ++k) {
    WorldDef def = periodic_def(GetParam(), 7);
    def.threads = k ? 7 : 1;
    Shifted water(def, busy_fluid(), {0, 0, 0});
    run(water.world, 5, 0.016f);
    hashes[k] = water.world.state_hash();
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

TEST_P(PeriodicTest, ReadOutsAndProbesSeeAcrossTheSeam) {
  const WorldDef def = periodic_def(GetParam(), 7);
  const Vec3 shift{0.25f, 0.2f, 0.2f};
  const auto measure = [&](Vec3 by) {
    Shifted water(def, busy_fluid(), by);
    std::vector<double> values;
    std::vector<ProbeId> probes;
    Vec3 at = Vec3{0.01f, -0.05f, -0.05f} + by;
    at += all_axes().wrap(at);
    for (const ProbeKind kind : {ProbeKind::point_pressure, ProbeKind::point_density, ProbeKind::flow}) {
      ProbeDef probe;
      probe.kind = kind;
      probe.point = at;
      if (kind == ProbeKind::flow) probe.radius = 0.12f;
      probes.push_back(water.world.create_probe(probe));
    }
    run(water.world, 3, 0.016f);
    for (const ProbeId probe : probes) values.push_back(water.world.probe(probe));
    for (const Ellipsoid& e : water.world.ellipsoids()) values.push_back(double{e.radii.x});
    return values;
  };
  const std::vector<double> middle = measure({0, 0, 0}), seam = measure(shift);
  EXPECT_GT(middle[0], 0);
  EXPECT_GT(middle[1], 900);
  for (size_t k = 0; k < middle.size(); ++k)
    EXPECT_NEAR(middle[k], seam[k], 2e-3 * std::max(0.1, std::fabs(middle[k]))) << k;
}

TEST_P(PeriodicTest, ASinkAndRemovalLeaveTheRest) {
  Shifted water(periodic_def(GetParam(), 7), {}, {0, 0, 0});
  SinkDef sink;
  sink.region = BoxRegion{{-0.25f, -1, -1}, {-0.15f, 1, 1}};
  water.world.create_sink(sink);
  const uint32_t removed = static_cast<uint32_t>(water.world.step(0.01f).removed);
  EXPECT_GT(removed, 50u);
  EXPECT_EQ(water.world.particle_count(), 640u - removed);
  run(water.world, 2, 0.01f);
}

TEST_P(PeriodicTest, ABeltCarriesViscousFluid) {
  WorldDef def = periodic_def(GetParam(), 5);
  def.gravity = {0, -9.81f, 0};
  for (const bool holds : {false, true}) {
    World world(def);
    ShapeDef belt = shape(PlaneGeometry{});
    belt.surface.belt_velocity = {0.5f, 3, 0};  // the part along the normal does not count
    if (holds) belt.surface.slip_length = 0;
    world.create_shape(belt);
    FluidDef honey;
    honey.dynamic_viscosity = 100;
    world.add_fluid(block(world.create_fluid(honey), {low.x, 0, low.z}, {0.25f, 0.2f, 0.15f}));
    run(world, 60, 0.016f);
    const Vec3 mean = (1.0f / float(world.particle_count())) * momentum(world);
    EXPECT_NEAR(mean.x, holds ? 0.5f : 0.0f, 0.02f);
    EXPECT_LT(std::fabs(mean.y) + std::fabs(mean.z), 0.05f);
  }
}

TEST_P(PeriodicTest, RefusesExtents) {
  constexpr auto bad = ErrorCode::invalid_argument;
  const auto make = [&](PeriodicExtent x) {
    WorldDef def = world_def(GetParam(), s);
    def.periodic.x = x;
    World world(def);
  };
  make({0, 8 * s});
  expect_error(bad, "periodic.x", [&] { make({0, 7.9f * s}); });
  expect_error(bad, "WorldDef::periodic.x.high is 0", [&] { make({0, 0}); });
  expect_error(bad, "periodic.x.high", [&] { make({1, -1}); });
  expect_error(bad, "periodic.x.high", [&] { make({-3e38f, 3e38f}); });
  expect_error(bad, "periodic.x.high", [&] { make({0, std::numeric_limits<float>::infinity()}); });
  expect_error(bad, "periodic.x.low", [&] { make({std::nanf(""), 1}); });
  WorldDef def = periodic_def(GetParam(), 1);
  def.diffuse.emplace();
  expect_error(bad, "diffuse", [&] { World world(def); });
  def = periodic_def(GetParam(), 1);
  for (const DensitySolver solver :
       {DensitySolver::grid, DensitySolver::pcisph, DensitySolver::wcsph, DensitySolver::dfsph}) {
    def.density.solver = solver;
    expect_error(bad, "jacobi or chebyshev", [&] { World world(def); });
  }
  World world(periodic_def(GetParam(), 1));
  expect_error(bad, "WorldDef::periodic", [&] { world.set_def(periodic_def(GetParam(), 3)); });
}

TEST_P(PeriodicTest, RefusesWhatKnowsOfNoSeams) {
  constexpr auto bad = ErrorCode::invalid_argument;
  World world(periodic_def(GetParam(), 1));
  const FluidId water = world.create_fluid({});
  expect_error(bad, "bodies", [&] { world.create_body({}); });
  expect_error(bad, "granular", [&] { world.create_granular({}); });
  RopeDef rope;
  rope.points = {{0, 0, 0}, {0, 0.2f, 0}};
  expect_error(bad, "ropes", [&] { world.create_rope(rope); });
  expect_error(bad, "cloth", [&] { world.create_cloth({}); });
  EmitterDef emitter;
  emitter.fluid = water;
  expect_error(bad, "emitters", [&] { world.create_emitter(emitter); });
  ProbeDef probe;
  probe.kind = ProbeKind::fluid_centre;
  expect_error(bad, "centre", [&] { world.create_probe(probe); });
  expect_error(bad, "periodic.x", [&] { world.add_particles(water, std::vector<Vec3>{{0.3f, 0, 0}}); });
  expect_error(bad, "periodic.x", [&] { world.add_fluid(block(water, {0, 0, 0}, {0.4f, 0.1f, 0.1f})); });
  BodyDef body;
  body.surface.belt_velocity = {1, 0, 0};
  World plain(world_def(GetParam(), s));
  expect_error(bad, "belt_velocity", [&] { plain.create_body(body); });
  EXPECT_EQ(world.particle_count(), 0u);
}

TEST_P(PeriodicTest, RefusesShapesThatDoNotRepeat) {
  constexpr auto bad = ErrorCode::invalid_argument;
  World world(periodic_def(GetParam(), 1));
  const auto refused = [&](ShapeDef def, const char* why) {
    def.name = "thing";
    expect_error(bad, "thing", [&] { world.create_shape(def); });
    expect_error(bad, why, [&] { world.create_shape(def); });
  };
  refused(shape(PlaneGeometry{{1, 0, 0}, 0}), "face along x");
  refused(tank({-0.2f, 0, 0}, {0.2f, 1, 1}), "face along x");
  refused(shape(BoxGeometry{{0.25f, 0.1f, 0.1f}}), "shorter");
  refused(shape(SphereGeometry{0.2f}), "shorter");
  refused(shape(SphereGeometry{0.05f}, {0.5f, 0, 0}), "beyond");
  world.create_shape(shape(PlaneGeometry{{0, 1, 0}, -1}));
  world.create_shape(shape(BoxGeometry{{0.4f, 0.1f, 0.1f}}, {0, -0.5f, 0}));  // reaches beyond both ends
  world.create_shape(shape(SphereGeometry{0.05f}, {0.24f, 0, 0}));
  ShapeDef channel = tank({-0.2f, -0.2f, -0.2f}, {0.2f, 0.2f, 0.2f});
  std::get<ContainerGeometry>(channel.geometry).openings = {{Face::x_low, {}}, {Face::x_high, {}}};
  world.create_shape(channel);
}

MENISCUS_ON_EACH_DEVICE(PeriodicTest);

TEST(SeamImages, OfACornerAreSeven) {
  const pbd::PeriodicAxes axes{{0, 0, 0}, {1, 2, 4}};
  EXPECT_EQ(pbd::SeamImages{axes.across_seams({0.5f, 1, 2}, 0.1f)}.count(), 0u);
  EXPECT_EQ(pbd::SeamImages{axes.across_seams({0.95f, 1, 2}, 0.1f)}.count(), 1u);
  const pbd::SeamImages images{axes.across_seams({0.05f, 1.95f, 0}, 0.1f)};
  ASSERT_EQ(images.count(), 7u);
  Vec3 sum{0, 0, 0};
  for (uint32_t n = 0; n < 7; ++n) {
    for (uint32_t m = 0; m < n; ++m) EXPECT_FALSE(images.offset(n) == images.offset(m));
    sum += images.offset(n);
  }
  EXPECT_EQ(sum, (Vec3{4, -8, 16}));
  EXPECT_EQ(axes.wrap({-0.5f, 5, 4}), (Vec3{1, -4, -4}));
}

}  // namespace
}  // namespace meniscus::tests
