// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Solids that are sharp, or smaller than the cloth's mesh, do not pass between its vertices.
#include <gtest/gtest.h>

#include <filesystem>

#include "collision/mesh/mesh.h"
#include "pbd/math/vec.h"
#include "tests/bench/harness/cloth_solid_distance.h"
#include "tests/devices.h"
#include "tests/many_threads.h"
#include "tests/triangle_intersections.h"

namespace meniscus::tests {
namespace {

using collision::ShapeKind;
using Motion = SolidSetup::Motion;

class FaceContacts : public OnDevice {};
MENISCUS_ON_EACH_DEVICE(FaceContacts);

constexpr float dt = 1 / 60.0f;

struct Sharp {
  const char* name;
  ShapeKind kind;
  Vec3 size;
  Quat rotation;
  float height;  ///< m, from its centre down to its lowest point
};

const Sharp sharp_ones[] = {
    {"ball", ShapeKind::sphere, {0.03f, 0, 0}, {0, 0, 0, 1}, 0.03f},
    {"corner", ShapeKind::box, {0.1f, 0.1f, 0.1f}, {0.325058f, 0, -0.325058f, 0.888074f}, 0.18f},
    {"edge", ShapeKind::box, {0.1f, 0.1f, 0.1f}, {0.382683f, 0, 0, 0.92388f}, 0.1415f},
    {"needle", ShapeKind::box, {0.005f, 0.2f, 0.005f}, {0, 0, 0, 1}, 0.2f},
    {"rod", ShapeKind::capsule, {0.01f, 0.2f, 0}, {0, 0, 0.707107f, 0.707107f}, 0.01f}};

/// Edges of 0.1 m, ten times the distance at which vertices stop.
ClothSolidSetup coarse_sheet(pbd::DeviceKind device) {
  ClothSolidSetup setup;
  setup.device = device;
  setup.mesh = cloth::make_sheet(1, 1, 11, 11);
  setup.fabric = {0.2f, 2000, 2000, 500, 1e-5f, false, false};
  setup.substeps = 16;
  return setup;
}

SolidSetup solid_of(const Sharp& sharp, Motion motion) {
  SolidSetup solid;
  solid.kind = sharp.kind;
  solid.size = sharp.size;
  solid.pose.rotation = sharp.rotation;
  solid.motion = motion;
  solid.mass = 0.2f;
  const float off = sharp.height + 0.02f;
  solid.pose.position = {0.053f, motion == Motion::fixed ? -off : off, 0.031f};
  return solid;
}

double least_distance(ClothSolidBench& bench, const ClothSolidSetup& setup) {
  const SolidSetup& solid = setup.solids[0];
  const Pose pose = solid.motion == Motion::fixed ? solid.pose : bench.rigid().pose(0);
  return ClothSolidDistance(solid, pose).least(setup.mesh, bench.positions());
}

/// Steps until all is over, and looks after each one.
double least_over(const ClothSolidSetup& setup, int steps) {
  const auto bench = make_cloth_solid_bench(setup);
  double least = 1e30;
  for (int k = 0; k < steps; ++k) {
    bench->step(dt);
    least = std::min(least, least_distance(*bench, setup));
  }
  return least;
}

// The relative motion of a step, in thicknesses: twice the distance at which vertices stop.
constexpr float thicknesses[] = {1, 5, 20};

float speed_of(const ClothSolidSetup& setup, float thickness) {
  return 2 * thickness * setup.radius / dt;
}

TEST_P(FaceContacts, KeepClothFromWhatIsFixed) {
  for (const Sharp& sharp : sharp_ones) {
    for (float thickness : thicknesses) {
      ClothSolidSetup setup = coarse_sheet(GetParam());
      setup.velocity = {0, -speed_of(setup, thickness), 0};
      setup.solids = {solid_of(sharp, Motion::fixed)};
      EXPECT_GE(least_over(setup, 12), 0) << sharp.name << ' ' << thickness;
    }
  }
}

TEST_P(FaceContacts, KeepOutWhatIsDriven) {
  for (const Sharp& sharp : sharp_ones) {
    for (float thickness : thicknesses) {
      ClothSolidSetup setup = coarse_sheet(GetParam());
      const float speed = speed_of(setup, thickness);
      setup.held = {0, 10, 110, 120};
      setup.solids = {solid_of(sharp, Motion::kinematic)};
      setup.solids[0].velocity = {0, -speed, 0};
      const int steps =
          std::max(1, static_cast<int>(0.25f / (speed * dt)));  // no further than cloth stretches
      EXPECT_GE(least_over(setup, steps), 0) << sharp.name << ' ' << thickness;
    }
  }
}

TEST_P(FaceContacts, KeepOutWhatIsThrown) {
  for (const Sharp& sharp : sharp_ones) {
    for (float thickness : thicknesses) {
      ClothSolidSetup setup = coarse_sheet(GetParam());
      setup.held = {0, 10, 110, 120};
      setup.solids = {solid_of(sharp, Motion::dynamic)};
      setup.solids[0].velocity = {0, -speed_of(setup, thickness), 0};
      EXPECT_GE(least_over(setup, 12), 0) << sharp.name << ' ' << thickness;
    }
  }
}

TEST_P(FaceContacts, AreWhatKeepsThemOut) {
  ClothSolidSetup setup = coarse_sheet(GetParam());
  setup.velocity = {0, -speed_of(setup, 1), 0};
  setup.solids = {solid_of(sharp_ones[3], Motion::fixed)};
  setup.face_points = false;
  EXPECT_LT(least_over(setup, 20), 0);
}

TEST_P(FaceContacts, KeepMomentum) {
  ClothSolidSetup setup = coarse_sheet(GetParam());
  setup.gravity = {0, 0, 0};
  setup.solids = {solid_of(sharp_ones[1], Motion::dynamic)};
  setup.solids[0].velocity = {0, -3, 0};
  const std::vector<float> masses = cloth::build_constraints(setup.mesh, setup.fabric).masses;
  const auto bench = make_cloth_solid_bench(setup);
  uint32_t points = 0;
  for (int k = 0; k < 40; ++k) {
    bench->step(dt);
    points = std::max(points, bench->points_wanted());
    const Vec3 body = bench->rigid().velocity(0);
    double p[3] = {0.2 * body.x, 0.2 * body.y, 0.2 * body.z};
    const std::vector<Vec3> v = bench->velocities();
    for (size_t i = 0; i < v.size(); ++i) {
      p[0] += masses[i] * v[i].x;
      p[1] += masses[i] * v[i].y;
      p[2] += masses[i] * v[i].z;
    }
    ASSERT_LT(std::hypot(p[0], p[1] + 0.6, p[2]), 1e-6 * 0.6) << k;
  }
  EXPECT_GT(points, 0u);
}

TEST_P(FaceContacts, AreNotNeededOnWhatIsSmoothAndLarge) {
  ClothSolidSetup setup = coarse_sheet(GetParam());
  setup.mesh = cloth::make_sheet(1, 1, 41, 41);
  SolidSetup solid;
  solid.size = {0.4f, 0, 0};
  solid.pose.position = {0, -0.42f, 0};
  setup.solids = {solid};
  const auto bench = make_cloth_solid_bench(setup);
  for (int k = 0; k < 10; ++k) {
    bench->step(dt);
    EXPECT_EQ(bench->points_wanted(), 0u);
  }
}

/// On the coarse mesh points support it; on the other, faces only just need them.
TEST_P(FaceContacts, LetClothRestOnABall) {
  for (int vertices : {9, 15}) {
    ClothSolidSetup setup = coarse_sheet(GetParam());
    setup.mesh = cloth::make_sheet(1, 1, vertices, vertices);
    setup.substeps = 16;
    setup.iterations = 1;
    setup.damping = 0.01f;
    SolidSetup ball;
    ball.size = {0.5f, 0, 0};
    ball.pose.position = {0, -0.52f, 0};
    setup.solids = {ball};
    const auto bench = make_cloth_solid_bench(setup);
    for (int k = 0; k < 240; ++k) bench->step(dt);
    double sum = 0;
    const std::vector<Vec3> velocities = bench->velocities();
    for (Vec3 v : velocities) sum += dot(v, v);
    EXPECT_LT(std::sqrt(sum / static_cast<double>(velocities.size())), 0.01) << vertices;
    EXPECT_GT(least_distance(*bench, setup), 0.6f * setup.radius) << vertices;
    EXPECT_GT(bench->points_wanted(), 0u) << vertices;
  }
}

TEST_P(FaceContacts, CarryABallAtRest) {
  for (float mass : {0.1f, 1.0f, 10.0f}) {
    ClothSolidSetup setup = coarse_sheet(GetParam());
    setup.fabric.warp_stiffness = setup.fabric.weft_stiffness = 20000;
    setup.held = {0, 10, 110, 120};
    setup.substeps = 8;
    setup.damping = 0.02f;
    SolidSetup ball;
    ball.size = {0.1f, 0, 0};
    ball.pose.position = {0, 0.12f, 0};
    ball.motion = Motion::dynamic;
    ball.mass = mass;
    ball.damping = 0.9f;
    setup.solids = {ball};
    const auto bench = make_cloth_solid_bench(setup);
    double least = 1e30, held = 0;
    constexpr int steps = 240, mean_over = 60;
    for (int k = 0; k < steps; ++k) {
      bench->step(dt);
      if (k % 30 == 0) least = std::min(least, least_distance(*bench, setup));
      if (k < steps - mean_over) continue;
      for (Vec3 r : bench->reactions()) held -= r.y / (mean_over * dt);
    }
    const double weight = 9.81 * (mass + 0.2 * (1 - 0.01 / 1.5));  // about: of the cloth that is not held
    EXPECT_NEAR(held / weight, 1, 0.02) << mass;
    EXPECT_LT(length(bench->rigid().velocity(0)), 0.05f) << mass;
    EXPECT_GE(least, 0) << mass;
  }
}

TEST_P(FaceContacts, LetABallFollowClothThatGoes) {
  ClothSolidSetup setup = coarse_sheet(GetParam());
  setup.substeps = 8;
  setup.damping = 0.02f;
  setup.fabric.warp_stiffness = setup.fabric.weft_stiffness = 20000;
  SolidSetup ball;
  ball.size = {0.1f, 0, 0};
  ball.pose.position = {0, 0.11f, 0};
  ball.motion = Motion::dynamic;
  ball.mass = 0.3f;
  ball.damping = 0.95f;
  SolidSetup frame;  // rests long enough for the ball to fall asleep, and then goes down
  frame.pose.position = {0, 1, 0};
  frame.motion = Motion::kinematic;
  frame.keyframes = {{0, frame.pose}, {6, frame.pose}, {7, {{0, 0.7f, 0}, {0, 0, 0, 1}}}};
  setup.solids = {ball, frame};
  for (uint32_t v : {0u, 10u, 110u, 120u})
    setup.attachments.push_back({v, 1, setup.mesh.vertices[v] - frame.pose.position});
  const auto bench = make_cloth_solid_bench(setup);
  for (int k = 0; k < 355; ++k) bench->step(dt);
  const float before = bench->rigid().pose(0).position.y;
  EXPECT_LT(length(bench->rigid().velocity(0)), 0.02f);
  for (int k = 0; k < 155; ++k) bench->step(dt);
  EXPECT_NEAR(bench->rigid().pose(0).position.y, before - 0.3f, 0.03f);
  EXPECT_LT(least_distance(*bench, setup), 2 * setup.radius);
  EXPECT_GE(least_distance(*bench, setup), 0);
}

TEST_P(FaceContacts, KeepClothFromTheBunny) {
  const char* const file = "/usr/share/glmark2/models/bunny.obj";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "the bunny of the package glmark2-data is not here";
  collision::TriangleMesh bunny = collision::load_mesh(file, 0.2f);  // 0.4 m high
  ClothSolidSetup setup = coarse_sheet(GetParam());
  setup.velocity = {0, -speed_of(setup, 5), 0};
  SolidSetup solid;
  solid.kind = ShapeKind::sdf;
  solid.mesh = &bunny;
  solid.pose.position = {0, -0.23f, 0};
  setup.solids = {solid};
  const auto bench = make_cloth_solid_bench(setup);
  for (int k = 0; k < 10; ++k) bench->step(dt);

  std::vector<Vec3> points = bench->positions();
  std::vector<TriangleIntersections::Triangle> triangles = setup.mesh.triangles;
  // Nothing keeps cloth from cloth here, and the bunny passes through itself in two places.
  const size_t of_cloth = TriangleIntersections(points, triangles).count();
  const auto first = static_cast<uint32_t>(points.size());
  for (Vec3 v : bunny.vertices) points.push_back(v + solid.pose.position);
  std::vector<TriangleIntersections::Triangle> own;
  for (const auto& t : bunny.triangles) own.push_back({t[0] + first, t[1] + first, t[2] + first});
  triangles.insert(triangles.end(), own.begin(), own.end());
  EXPECT_EQ(TriangleIntersections(points, triangles).count(),
            of_cloth + TriangleIntersections(points, own).count());
}

TEST_P(FaceContacts, GiveTheSameBitsOnAnyNumberOfThreads) {
  const ManyThreads allowed;
  std::vector<std::vector<Vec3>> results;
  for (int threads : {1, 2, 5}) {
    ClothSolidSetup setup = coarse_sheet(GetParam());
    setup.threads = threads;
    setup.velocity = {0, -speed_of(setup, 5), 0};
    setup.solids = {solid_of(sharp_ones[1], Motion::fixed)};
    const auto bench = make_cloth_solid_bench(setup);
    for (int k = 0; k < 15; ++k) bench->step(dt);
    results.push_back(bench->positions());
  }
  for (const std::vector<Vec3>& other : results) {
    for (size_t i = 0; i < other.size(); ++i) ASSERT_EQ(other[i], results[0][i]) << i;
  }
}

TEST_P(FaceContacts, AllocateNothingInWarmSteps) {
  ClothSolidSetup setup = coarse_sheet(GetParam());
  setup.held = {0, 10, 110, 120};
  setup.solids = {solid_of(sharp_ones[1], Motion::dynamic)};
  const auto bench = make_cloth_solid_bench(setup);
  for (int k = 0; k < 30; ++k) bench->step(dt);
  const uint64_t before = bench->memory().allocations;
  for (int k = 0; k < 10; ++k) bench->step(dt);
  EXPECT_EQ(bench->memory().allocations, before);
}

}  // namespace
}  // namespace meniscus::tests
