// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Fluid against solids that do not move: it stays out of them, and they give it no energy.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "tests/unit/collision/mesh_shapes.h"
#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

constexpr float s = 0.0625f;

/// A file with a ball of 0.2 m radius, for as long as it lives.
class BallFile {
 public:
  BallFile() {
    const collision::TriangleMesh ball = collision::ball_mesh(0.2f, 3);
    std::ofstream out(path_);
    for (Vec3 v : ball.vertices) out << "v " << v.x << ' ' << v.y << ' ' << v.z << '\n';
    for (const auto& t : ball.triangles)
      out << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  }
  ~BallFile() { std::filesystem::remove(path_); }

  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_ =
      std::filesystem::temp_directory_path() / ("meniscus_ball_" + std::to_string(getpid()) + ".obj");
};

class StaticShapesTest : public OnDevice {
 protected:
  /// A dam breaks over the obstacle for 1.6 s.
  void expect_held(const ShapeDef& obstacle) {
    World world(world_def(GetParam(), s));
    world.create_shape(tank({0, 0, 0}, {1, 1, 0.5f}));
    world.create_shape(obstacle);
    const FluidId water = world.create_fluid({});
    world.add_fluid(block(water, {0, 0, 0}, {0.4375f, 0.75f, 0.5f}));
    const size_t count = world.particle_count();
    const double start = energy(world), floor = rest_energy(world, water);
    double last = start;
    for (int k = 0; k < 100; ++k) {
      world.step(0.016f);
      const Diagnostics d = world.diagnostics();
      last = d.kinetic_energy + d.potential_energy;
      EXPECT_EQ(d.outside, 0u) << "step " << k;
      EXPECT_EQ(d.non_finite, 0u) << "step " << k;
      ASSERT_LT(last - floor, 1.03 * (start - floor)) << "step " << k;
    }
    EXPECT_EQ(world.particle_count(), count);
    EXPECT_LT(last - floor, 0.8 * (start - floor));
    EXPECT_LT(world.diagnostics().density_error_mean, 0.02);
  }

  /// Of the same water, spread level over the tank's floor of 1 × 0.5 m.
  static double rest_energy(const World& world, FluidId water) {
    const double mass = double{world.particle_mass(water)} * static_cast<double>(world.particle_count());
    const double depth = mass / 1000 / 0.5;
    return mass * 9.81 * depth / 2;
  }
};

TEST_P(StaticShapesTest, ABall) {
  expect_held(shape(SphereGeometry{0.2f}, {0.7f, 0.1f, 0.25f}));
}

TEST_P(StaticShapesTest, ABox) {
  ShapeDef box = shape(BoxGeometry{{0.1f, 0.15f, 0.12f}}, {0.7f, 0.1f, 0.25f});
  box.pose.rotation = about_z(30);
  expect_held(box);
}

TEST_P(StaticShapesTest, ACapsule) {
  ShapeDef capsule = shape(CapsuleGeometry{0.1f, 0.1f}, {0.7f, 0.15f, 0.25f});
  capsule.pose.rotation = about_z(60);
  expect_held(capsule);
}

TEST_P(StaticShapesTest, ACylinder) {
  expect_held(shape(CylinderGeometry{0.12f, 0.3f}, {0.7f, 0.2f, 0.25f}));
}

TEST_P(StaticShapesTest, AMesh) {
  const BallFile file;
  expect_held(shape(MeshGeometry{file.path(), 1, 0}, {0.7f, 0.1f, 0.25f}));
}

TEST_P(StaticShapesTest, AThinWallWithFriction) {
  ShapeDef wall = shape(BoxGeometry{{0.004f, 0.2f, 0.25f}}, {0.7f, 0.2f, 0.25f});
  wall.surface.friction = 0.5f;
  expect_held(wall);
}

TEST_P(StaticShapesTest, ABouncyBall) {
  ShapeDef ball = shape(SphereGeometry{0.2f}, {0.7f, 0.1f, 0.25f});
  ball.surface.restitution = 0.7f;
  expect_held(ball);
}

// Two metres a second, downwards at a slant, onto hills.
TEST_P(StaticShapesTest, AJetOnAHeightField) {
  World world(world_def(GetParam(), 0.05f));
  HeightFieldGeometry hills{21, 21, 0.1f, {}};
  for (int n = 0; n < 441; ++n) {
    const float x = 0.1f * float(n % 21), z = 0.1f * float(n / 21);
    hills.heights.push_back(0.1f * std::sin(4 * x) * std::cos(3 * z));
  }
  world.create_shape(shape(hills));
  const FluidId water = world.create_fluid({});
  world.create_sink({"", BoxRegion{{-3, -1, -3}, {3, 3, 3}}, true, {}, {}});
  size_t made = 0, gone = 0;
  for (int k = 0; k < 60; ++k) {
    if (k % 3 == 0 && k < 45) {
      const std::vector<Vec3> layer = lattice(4, 2, 4, 0.05f, {-0.1f, 0.8f, -0.1f});
      made += layer.size();
      world.add_particles(water, layer, std::vector<Vec3>(layer.size(), Vec3{0.5f, -2, 0}));
    }
    gone += world.step(0.016f).removed;
    const Diagnostics d = world.diagnostics();
    EXPECT_EQ(d.outside, 0u) << "step " << k;
    EXPECT_LT(d.max_speed, std::sqrt(4.25f + 2 * 9.81f * 2)) << "step " << k;  // the fall of two metres more
  }
  EXPECT_EQ(world.particle_count() + gone, made);
  EXPECT_GT(world.particle_count(), made / 4);
}

// A block set down on a slope without friction runs off; on a rough one of glue-like friction it stays
// longer.
TEST_P(StaticShapesTest, FrictionHoldsFluidBack) {
  double travelled[2];
  for (int rough : {0, 1}) {
    World world(world_def(GetParam(), 0.05f));
    const Vec3 normal{std::sin(0.25f), std::cos(0.25f), 0};
    ShapeDef slope = shape(PlaneGeometry{normal, 0});
    slope.surface.friction = rough ? 1.0f : 0.0f;
    world.create_shape(slope);
    FluidVolumeDef fill = block(world.create_fluid({}), {0, 0, 0}, {0.4f, 0.2f, 0.4f});
    fill.pose.rotation = about_z(-0.25f * 180 / 3.14159265f);
    world.add_fluid(fill);
    run(world, 60, 0.01f);
    double x = 0;
    for (Vec3 p : world.positions()) x += p.x;
    travelled[rough] = x / static_cast<double>(world.particle_count()) - 0.2;
  }
  EXPECT_GT(travelled[0], 0.3);
  EXPECT_LT(travelled[1], 0.8 * travelled[0]);
}

MENISCUS_ON_EACH_DEVICE(StaticShapesTest);

}  // namespace
}  // namespace meniscus::tests
