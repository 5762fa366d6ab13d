// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Fast particles against thin solids: none may pass through.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "tests/unit/collision/mesh_shapes.h"
#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

constexpr float s = 0.05f, radius = 0.5f * s;
constexpr float substep = 0.0025f;

class SweepTest : public OnDevice {
 protected:
  static constexpr float speeds[] = {1, 2, 5, 10, 20};  // radii a substep

  World empty_world() const {
    WorldDef def = world_def(GetParam(), s);
    def.gravity = {0, 0, 0};
    return World(def);
  }

  /// 12 × 12 particles in a square of 1.1 m, too far apart to meet, a metre before x = 0; each one's start
  /// differs by a part of its step.
  static std::vector<Vec3> volley() {
    std::vector<Vec3> points;
    for (int n = 0; n < 144; ++n) {
      points.push_back(
          {-1 - 0.37f * float(n % 7) / 7, 0.101f * (float(n % 12) - 5.5f), 0.101f * (float(n / 12) - 5.5f)});
    }
    return points;
  }

  /// Flies long enough for every particle to have passed x = 1, and calls check after each step.
  template <class Check>
  static void fly(World& world, float speed, const Check& check) {
    const int steps = 1 + static_cast<int>(2.5f / (4 * speed * radius));
    for (int k = 0; k < steps; ++k) {
      world.step(4 * substep);
      check();
    }
  }

  static void shoot(World& world, float speed, Vec3 direction = {1, 0, 0}) {
    const std::vector<Vec3> points = volley();
    const std::vector<Vec3> velocities(points.size(), speed * radius / substep * direction);
    world.add_particles(world.create_fluid({}), points, velocities);
  }
};

TEST_P(SweepTest, AThinWallStopsAll) {
  for (float speed : speeds) {
    for (float restitution : {0.0f, 0.5f}) {
      World world = empty_world();
      ShapeDef sheet = shape(BoxGeometry{{0.1f * radius, 1, 1}});  // a fifth of a radius thick
      sheet.surface.restitution = restitution;
      world.create_shape(sheet);
      shoot(world, speed);
      fly(world, speed, [] {});
      for (Vec3 p : world.positions()) EXPECT_LT(p.x, 0) << speed << " radii a substep";
    }
  }
}

TEST_P(SweepTest, AThinWallStopsAllAtASlant) {
  for (float speed : speeds) {
    World world = empty_world();
    ShapeDef sheet = shape(BoxGeometry{{0.1f * radius, 30, 30}});
    sheet.pose.rotation = about_z(35);
    world.create_shape(sheet);
    const Vec3 normal = rotate(sheet.pose.rotation, {1, 0, 0});
    shoot(world, speed, normalized_or({1, 0.2f, -0.4f}, {1, 0, 0}));
    fly(world, speed, [] {});
    for (Vec3 p : world.positions()) EXPECT_LT(dot(normal, p), 0) << speed << " radii a substep";
  }
}

TEST_P(SweepTest, NothingFliesThroughABall) {
  for (const Geometry& geometry : {Geometry{SphereGeometry{0.3f}}, Geometry{CapsuleGeometry{0.3f, 0.1f}},
                                   Geometry{CylinderGeometry{0.3f, 0.4f}}}) {
    for (float speed : speeds) {
      World world = empty_world();
      world.create_shape(shape(geometry));
      shoot(world, speed);
      const std::vector<Vec3> start = volley();
      fly(world, speed, [&] { EXPECT_EQ(world.diagnostics().outside, 0u); });
      for (size_t i = 0; i < start.size(); ++i) {
        const bool aside = length(Vec3{0, start[i].y, start[i].z}) > 0.9f * 0.3f;
        const Vec3 p = world.positions()[i];
        // A particle beyond it went around it, and so is off the straight line.
        const float turned = length(Vec3{0, p.y - start[i].y, p.z - start[i].z});
        if (p.x > 0.3f && !aside) {
          EXPECT_GT(turned, 0.02f) << speed << " radii a substep";
        }
      }
    }
  }
}

TEST_P(SweepTest, AMeshStopsAll) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("meniscus_sweep_" + std::to_string(getpid()) + ".obj");
  const collision::TriangleMesh slab = collision::box_mesh({-0.03f, -0.7f, -0.7f}, {0.03f, 0.7f, 0.7f});
  {
    std::ofstream out(file);
    for (Vec3 v : slab.vertices) out << "v " << v.x << ' ' << v.y << ' ' << v.z << '\n';
    for (const auto& t : slab.triangles)
      out << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  }
  for (float speed : speeds) {
    World world = empty_world();
    world.create_shape(shape(MeshGeometry{file.string(), 1, 0}));
    shoot(world, speed);
    fly(world, speed, [] {});
    for (Vec3 p : world.positions()) EXPECT_LT(p.x, 0) << speed << " radii a substep";
  }
  std::filesystem::remove(file);
}

// Two thin walls that meet at a right angle; a particle that one stops slides on towards the other.
TEST_P(SweepTest, TheInnerCornerOfTwoThinWallsStopsAll) {
  for (float speed : speeds) {
    World world = empty_world();
    const float half = 0.1f * radius;
    world.create_shape(shape(BoxGeometry{{half, 2, 2}}, {0, -1 + half, 0}));
    world.create_shape(shape(BoxGeometry{{2, half, 2}}, {-2, 1, 0}));
    shoot(world, speed, normalized_or({1, 0.7f, 0}, {1, 0, 0}));
    fly(world, speed, [] {});
    for (Vec3 p : world.positions()) {
      EXPECT_TRUE(p.x < 0 && p.y < 1) << speed << " radii a substep, at " << p.x << " " << p.y;
    }
  }
}

TEST_P(SweepTest, AHeightFieldStopsAll) {
  HeightFieldGeometry hills{40, 40, 0.1f, {}};
  for (int i = 0; i < 1600; ++i)
    hills.heights.push_back(0.05f * std::sin(0.7f * float(i % 40)) * std::cos(0.5f * float(i / 40)));
  for (float speed : speeds) {
    World world = empty_world();
    ShapeDef ground = shape(hills);
    ground.pose.rotation = about_z(90);  // its up is −x, whence the particles come
    world.create_shape(ground);
    shoot(world, speed);
    // A particle that moves along the hills may enter the next one for a step; it does not stay there.
    fly(world, speed, [] {});
    EXPECT_EQ(world.diagnostics().outside, 0u) << speed << " radii a substep";
    for (Vec3 p : world.positions()) EXPECT_LT(p.x, 0.05f) << speed << " radii a substep";
  }
}

TEST_P(SweepTest, APlaneStopsAll) {
  for (float speed : speeds) {
    World world = empty_world();
    world.create_shape(shape(PlaneGeometry{{-1, 0, 0}, 0}));
    shoot(world, speed);
    fly(world, speed, [&] { EXPECT_EQ(world.diagnostics().outside, 0u); });
  }
}

TEST_P(SweepTest, ATurningVolleyStaysInItsContainer) {
  for (float speed : speeds) {
    World world = empty_world();
    ShapeDef walls = tank({-1.5f, -0.7f, -0.7f}, {1, 0.7f, 0.7f});
    walls.surface.restitution = 0.9f;
    world.create_shape(walls);
    std::mt19937 random(8);
    const std::vector<Vec3> points = volley();
    std::vector<Vec3> velocities;
    for (size_t i = 0; i < points.size(); ++i) {
      velocities.push_back(speed * radius / substep * normalized_or(random_vector(random, 1), {1, 0, 0}));
    }
    world.add_particles(world.create_fluid({}), points, velocities);
    for (int k = 0; k < 30; ++k) {
      world.step(4 * substep);
      EXPECT_EQ(world.diagnostics().outside, 0u) << speed << " radii a substep";
    }
  }
}

// The solve throws overlapping particles apart, further than contacts were looked for.
TEST_P(SweepTest, ABurstStaysInItsContainer) {
  for (float distance : {1.55f, 2.0f, 3.0f}) {
    WorldDef def = world_def(GetParam(), 0.05f);
    def.substeps = 1;
    def.gravity = {0, 0, 0};
    World world(def);
    world.create_shape(tank({-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f}));
    std::mt19937 random(3);
    std::vector<Vec3> clump;
    for (int n = 0; n < 1080; ++n) {
      clump.push_back(Vec3{0.5f - distance * 0.05f - 0.02f, 0, 0} + random_vector(random, 0.02f));
    }
    world.add_particles(world.create_fluid({}), clump);
    for (int k = 0; k < 5; ++k) {
      world.step(0.016f);
      EXPECT_EQ(world.diagnostics().outside, 0u) << distance << " spacings from the wall, step " << k;
    }
  }
}

MENISCUS_ON_EACH_DEVICE(SweepTest);

}  // namespace
}  // namespace meniscus::tests
