// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the surface mesh of a fluid.
#include "fluid/surface/surface_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "tests/many_threads.h"
#include "tests/unit/fluid/surfaces.h"
#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

constexpr float s = 0.05f;

std::vector<Vec3> ball(float radius, Vec3 centre = {0, 0, 0}) {
  const int n = static_cast<int>(std::ceil(2 * radius / s)) + 2;
  const float half = 0.5f * static_cast<float>(n) * s;
  std::vector<Vec3> points = lattice(n, n, n, s, centre - Vec3{half, half, half});
  std::erase_if(points, [&](Vec3 p) { return length(p - centre) > radius; });
  return points;
}

std::vector<Vec3> cloud(int count, float half, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) points.push_back(random_vector(random, half));
  return points;
}

void expect_closed(const SurfaceMesh& mesh) {
  EXPECT_EQ(mesh.normals.size(), mesh.vertices.size());
  EXPECT_EQ(open_edges(mesh.triangles), 0u);
  EXPECT_EQ(broken_rings(mesh.triangles), 0u);
  std::vector<bool> used(mesh.vertices.size(), false);
  for (const auto& t : mesh.triangles) {
    for (const uint32_t v : t) {
      ASSERT_LT(v, used.size());
      used[v] = true;
    }
  }
  EXPECT_EQ(std::count(used.begin(), used.end(), false), 0) << "vertices without a triangle";
}

double volume_of(const SurfaceMesh& mesh) {
  return volume_inside(mesh.vertices, mesh.triangles);
}

class SurfaceMeshTest : public OnDevice {
 protected:
  World world_of(std::span<const Vec3> points, float support_ratio = 2) const {
    WorldDef def = world_def(GetParam(), s);
    def.gravity = {0, 0, 0};
    def.support_ratio = support_ratio;
    World world(def);
    world.add_particles(world.create_fluid({}), points);
    return world;
  }
};

TEST_P(SurfaceMeshTest, ABallIsClosedAndHasItsVolume) {
  for (const float support_ratio : {1.5f, 2.0f, 3.0f}) {
    for (const float radius : {5.3f, 10.6f}) {
      const std::vector<Vec3> points = ball(radius * s);
      const SurfaceMesh mesh = world_of(points, support_ratio).surface_mesh();
      expect_closed(mesh);
      const double volume = static_cast<double>(points.size()) * std::pow(double{s}, 3);
      const double excess = volume_of(mesh) - volume,
                   area = 4 * std::numbers::pi * std::pow(double{radius * s}, 2);
      EXPECT_LT(std::abs(excess / area), 0.06 * double{s}) << radius << " spacings, h/s " << support_ratio;
      if (radius > 10) {
        EXPECT_LT(std::abs(excess / volume), 0.01) << "h/s " << support_ratio;
      }
    }
  }
}

TEST_P(SurfaceMeshTest, ABallThatHasRelaxedHasItsVolumeToo) {
  World world = world_of(ball(10.6f * s));
  run(world, 10, 0.008f);
  const double volume = static_cast<double>(world.particle_count()) * std::pow(double{s}, 3);
  const SurfaceMesh mesh = world.surface_mesh();
  expect_closed(mesh);
  EXPECT_NEAR(volume_of(mesh) / volume, 1, 0.01);
}

TEST_P(SurfaceMeshTest, NormalsOfABallPointOutwards) {
  const SurfaceMesh mesh = world_of(ball(8.2f * s)).surface_mesh();
  double sum = 0;
  for (size_t i = 0; i < mesh.vertices.size(); ++i) {
    ASSERT_NEAR(length(mesh.normals[i]), 1, 1e-4);
    sum += double{dot(mesh.normals[i], normalized_or(mesh.vertices[i], {0, 1, 0}))};
  }
  EXPECT_GT(sum / static_cast<double>(mesh.vertices.size()), 0.98);
}

TEST_P(SurfaceMeshTest, APoolEndsHalfASpacingAboveItsTopParticles) {
  const SurfaceMesh mesh = world_of(lattice(14, 8, 14, s, {0, 0, 0})).surface_mesh();
  double sum = 0, squares = 0;
  int count = 0;
  for (const Vec3 p : mesh.vertices) {
    if (std::abs(p.x - 7 * s) > 3 * s || std::abs(p.z - 7 * s) > 3 * s || p.y < 4 * s) continue;
    sum += double{p.y} / s;
    squares += double{p.y} * p.y / (s * s);
    ++count;
  }
  ASSERT_GT(count, 50);
  const double mean = sum / count;
  EXPECT_NEAR(mean, 8, 0.06);
  EXPECT_LT(std::sqrt(std::max(0.0, squares / count - mean * mean)), 0.02) << "it is bumpy";
}

TEST_P(SurfaceMeshTest, ADropOnItsOwnKeepsItsVolume) {
  for (const Vec3 at : {Vec3{0, 0, 0}, Vec3{0.013f, -3.3f, 2.01f}}) {
    const Vec3 points[] = {at};
    SurfaceMeshDef def;
    def.cell_size = 0.15f;
    const SurfaceMesh mesh = world_of(points).surface_mesh(def);
    expect_closed(mesh);
    EXPECT_NEAR(volume_of(mesh) / (s * s * s), 1, 0.05);
  }
}

TEST_P(SurfaceMeshTest, WhateverTheParticlesDoItIsClosed) {
  std::vector<Vec3> pile(300, Vec3{0.02f, 0.01f, 0});  // all at one place
  const std::vector<Vec3> sheet = lattice(12, 1, 12, s, {0, 0, 0}), thread = lattice(30, 1, 1, s, {0, 0, 0});
  for (const std::vector<Vec3>& points : {cloud(200, 0.3f, 1), cloud(3000, 0.5f, 2), cloud(2000, 0.1f, 3),
                                          cloud(500, 2.0f, 4), pile, sheet, thread}) {
    for (const float cell : {0.4f, 0.5f, 1.0f, 1.7f}) {
      SurfaceMeshDef def;
      def.cell_size = cell;
      const SurfaceMesh mesh = world_of(points).surface_mesh(def);
      expect_closed(mesh);
      // A coarse grid may miss what is thin.
      EXPECT_TRUE(cell > 0.5f || !mesh.triangles.empty());
    }
  }
}

TEST_P(SurfaceMeshTest, ASplashIsClosedInEveryFrame) {
  World world = dam_break(GetParam());
  for (int k = 0; k < 5; ++k) {
    run(world, 12, 0.016f);
    expect_closed(world.surface_mesh());
  }
}

fluid::SurfaceField surface_field(double spacing, float cell_size) {
  fluid::SurfaceField field = fluid::calibrate_surface(spacing, 2 * spacing);
  field.cell = cell_size * static_cast<float>(spacing);
  return field;
}

/// The field by its definition, at one point.
double field_at(std::span<const Ellipsoid> ellipsoids, const fluid::SurfaceField& f, Vec3 p) {
  double sum = 0;
  for (const Ellipsoid& e : ellipsoids) {
    const Vec3 d = rotate(conjugate(e.rotation), p - e.centre);
    const double x = d.x / (f.reach * e.radii.x), y = d.y / (f.reach * e.radii.y),
                 z = d.z / (f.reach * e.radii.z);
    const double left = 1 - (x * x + y * y + z * z);
    if (left <= 0) continue;
    const double volume = double{e.radii.x} * e.radii.y * e.radii.z;
    sum += f.weight * std::pow(f.unit_volume / volume, double{f.power}) * left * left * left;
  }
  return sum;
}

TEST_P(SurfaceMeshTest, ASlowReferenceFindsTheSameSurface) {
  World world = dam_break(GetParam(), 0.1f);
  run(world, 20, 0.016f);
  SurfaceMeshDef def;
  def.cell_size = 0.8f;
  const SurfaceMesh mesh = world.surface_mesh(def);
  const auto ellipsoids = world.ellipsoids();
  const fluid::SurfaceField f = surface_field(0.1, 0.8f);
  // Every edge of a dense grid that the surface cuts, and where.
  constexpr int nx = 22, ny = 30, nz = 14, origin = -4;
  std::vector<double> values;
  const auto place = [&](int x, int y, int z) {
    return f.cell * Vec3{float(x + origin), float(y + origin), float(z + origin)};
  };
  for (int i = 0; i < nx * ny * nz; ++i)
    values.push_back(field_at(ellipsoids, f, place(i % nx, i / nx % ny, i / nx / ny)) - double{f.iso});
  std::vector<Vec3> expected;
  const int strides[] = {1, nx, nx * ny};
  for (int i = 0; i < nx * ny * nz; ++i) {
    const int at[] = {i % nx, i / nx % ny, i / nx / ny}, size[] = {nx, ny, nz};
    for (int axis = 0; axis < 3; ++axis) {
      if (at[axis] + 1 == size[axis]) continue;
      const double a = values[size_t(i)], b = values[size_t(i + strides[axis])];
      if ((a >= 0) == (b >= 0)) continue;
      const Vec3 along{float(axis == 0), float(axis == 1), float(axis == 2)};
      expected.push_back(place(at[0], at[1], at[2]) + (f.cell * float(a / (a - b))) * along);
    }
  }
  ASSERT_GT(expected.size(), 400u);
  ASSERT_EQ(mesh.vertices.size(), expected.size());
  for (const Vec3 e : expected) {
    float nearest = 1;
    for (const Vec3 v : mesh.vertices) nearest = std::min(nearest, length(v - e));
    EXPECT_LT(nearest, 2e-3f * f.cell);
  }
}

TEST_P(SurfaceMeshTest, MemoryGoesWithTheParticlesAndNotWithTheSpaceBetweenThem) {
  std::vector<Vec3> near = ball(2 * s), far = near;
  for (const Vec3 p : ball(2 * s, {0, 1, 0})) near.push_back(p);
  for (const Vec3 p : ball(2 * s, {900, 800, -1000})) far.push_back(p);
  World first = world_of(near), second = world_of(far);
  EXPECT_GT(first.surface_mesh().triangles.size(), 0u);
  const SurfaceMesh mesh = second.surface_mesh();
  expect_closed(mesh);
  EXPECT_GT(std::count_if(mesh.vertices.begin(), mesh.vertices.end(), [](Vec3 p) { return p.x > 100; }), 50);
  EXPECT_LT(second.device_bytes(), first.device_bytes() + (1u << 20));
}

TEST_P(SurfaceMeshTest, OneFluidOrAllButNoGrains) {
  WorldDef def = world_def(GetParam(), s);
  World world(def);
  const FluidId water = world.create_fluid({}), oil = world.create_fluid({});
  const FluidId sand = world.create_granular({});
  const FluidId none = world.create_fluid({});
  world.add_particles(water, ball(3.1f * s));
  world.add_particles(oil, ball(4.1f * s, {1, 0, 0}));
  world.add_particles(sand, ball(3.1f * s, {2, 0, 0}));
  const auto reach = [](const SurfaceMesh& mesh) {
    float low = 1e9f, high = -1e9f;
    for (const Vec3 p : mesh.vertices) {
      low = std::min(low, p.x);
      high = std::max(high, p.x);
    }
    return std::pair{std::lround(low), std::lround(high)};
  };
  EXPECT_EQ(reach(world.surface_mesh()), (std::pair{0l, 1l}));
  EXPECT_EQ(reach(world.surface_mesh({.fluid = water})), (std::pair{0l, 0l}));
  EXPECT_EQ(reach(world.surface_mesh({.fluid = oil})), (std::pair{1l, 1l}));
  EXPECT_EQ(reach(world.surface_mesh({.fluid = sand})), (std::pair{2l, 2l}));
  EXPECT_TRUE(world.surface_mesh({.fluid = none}).vertices.empty());
}

TEST_P(SurfaceMeshTest, AHigherLevelIsThinner) {
  const World world = world_of(ball(5 * s));
  double before = 1e9;
  for (const float level : {0.5f, 1.0f, 2.0f}) {
    SurfaceMeshDef def;
    def.level = level;
    const double volume = volume_of(world.surface_mesh(def));
    EXPECT_LT(volume, before);
    before = volume;
  }
}

TEST_P(SurfaceMeshTest, WithoutParticlesItIsEmpty) {
  World world(world_def(GetParam(), s));
  EXPECT_TRUE(world.surface_mesh().triangles.empty());
  world.create_fluid({});
  EXPECT_TRUE(world.surface_mesh().vertices.empty());
}

TEST_P(SurfaceMeshTest, WrongArgumentsAreNamed) {
  World world = world_of(ball(2 * s));
  const auto message = [&](const SurfaceMeshDef& def) {
    try {
      world.surface_mesh(def);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message({.cell_size = 0.05f}),
            "SurfaceMeshDef::cell_size is 0.05; it must be at least 0.1 and at most 2 spacings");
  EXPECT_EQ(message({.level = 9}), "SurfaceMeshDef::level is 9; it must be at least 0.2 and at most 3");
  EXPECT_EQ(message({.cell_size = std::nanf("")}),
            "SurfaceMeshDef::cell_size is nan; it must be at least 0.1 and at most 2 spacings");
  EXPECT_NE(message({.fluid = FluidId{}}), "");
}

TEST_P(SurfaceMeshTest, ItLeavesTheStateAsItIsAndIsTheSameEachTime) {
  World world = dam_break(GetParam()), other = dam_break(GetParam());
  run(world, 10, 0.016f);
  run(other, 10, 0.016f);
  const SurfaceMesh first = world.surface_mesh(), again = world.surface_mesh();
  EXPECT_EQ(first.triangles, again.triangles);
  EXPECT_EQ(std::memcmp(first.vertices.data(), again.vertices.data(), first.vertices.size() * sizeof(Vec3)),
            0);
  run(world, 3, 0.016f);
  run(other, 3, 0.016f);
  EXPECT_EQ(world.state_hash(), other.state_hash());
}

TEST_P(SurfaceMeshTest, EveryNumberOfThreadsGivesTheSameBits) {
  if (GetParam() != pbd::DeviceKind::cpu) GTEST_SKIP() << "threads are the CPU's";
  const ManyThreads many;
  SurfaceMesh first;
  for (const int threads : {1, 8}) {
    WorldDef def = world_def(GetParam(), s);
    def.threads = threads;
    World world = dam_break(def);
    run(world, 5, 0.016f);
    const SurfaceMesh now = world.surface_mesh();
    if (first.vertices.empty()) first = now;
    EXPECT_EQ(now.triangles, first.triangles);
    ASSERT_EQ(now.vertices.size(), first.vertices.size());
    EXPECT_EQ(std::memcmp(now.vertices.data(), first.vertices.data(), now.vertices.size() * sizeof(Vec3)), 0);
    EXPECT_EQ(std::memcmp(now.normals.data(), first.normals.data(), now.normals.size() * sizeof(Vec3)), 0);
    EXPECT_EQ(
        std::memcmp(now.velocities.data(), first.velocities.data(), now.velocities.size() * sizeof(Vec3)), 0);
  }
}

MENISCUS_ON_EACH_DEVICE(SurfaceMeshTest);

}  // namespace
}  // namespace meniscus::tests
