// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Bodies on fixed and kinematic meshes and on height fields, with contacts that a device solves.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/collision/rigid/device_scene.h"

namespace meniscus::collision {

namespace {

constexpr float dt = 0.004f, half = 0.05f, pi = 3.14159265f;

/// A flat square of 2 m with its top at y = 0, in squares of `cell` (m), as a closed mesh.
TriangleMesh slab(float cell) {
  TriangleMesh mesh;
  const auto n = static_cast<uint32_t>(std::lround(2 / cell)) + 1;
  for (const float y : {0.0f, -0.5f})
    for (uint32_t j = 0; j < n; ++j)
      for (uint32_t i = 0; i < n; ++i)
        mesh.vertices.push_back({cell * static_cast<float>(i) - 1, y, cell * static_cast<float>(j) - 1});
  const auto quad = [&](uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  const uint32_t under = n * n;
  for (uint32_t j = 0; j + 1 < n; ++j) {
    for (uint32_t i = 0; i + 1 < n; ++i) {
      const uint32_t a = j * n + i;
      quad(a, a + n, a + n + 1, a + 1);
      quad(under + a, under + a + 1, under + a + n + 1, under + a + n);
    }
  }
  for (uint32_t i = 0; i + 1 < n; ++i) {
    const uint32_t last = n * (n - 1) + i, left = n * i, right = left + n - 1;
    quad(i, i + 1, under + i + 1, under + i);
    quad(last + 1, last, under + last, under + last + 1);
    quad(left + n, left, under + left, under + left + n);
    quad(right, right + n, under + right + n, under + right);
  }
  return mesh;
}

HeightFieldGeometry height_field(int count, float cell, float (*height)(float, float)) {
  HeightFieldGeometry field;
  field.columns = field.rows = count;
  field.cell_size = cell;
  for (int j = 0; j < count; ++j)
    for (int i = 0; i < count; ++i)
      field.heights.push_back(height(cell * (static_cast<float>(i) - 0.5f * static_cast<float>(count - 1)),
                                     cell * (static_cast<float>(j) - 0.5f * static_cast<float>(count - 1))));
  return field;
}

RigidPart field_part(const HeightFieldGeometry& field) {
  RigidPart part;
  part.kind = Kind::height_field;
  part.heights = field;
  return part;
}

RigidBodyDef sleepless(RigidBodyDef def) {
  def.can_sleep = false;
  return def;
}

const RigidPart shapes[] = {box_part({half, half, half}), round_part(Kind::sphere, half),
                            round_part(Kind::capsule, half, half),
                            mesh_part(Kind::hull, box_mesh({-half, -half, -half}, {half, half, half}))};

}  // namespace

TEST(RigidGround, SolidsRestOnMeshesAndHeightFields) {
  const RigidPart grounds[] = {mesh_part(Kind::mesh, slab(2)), mesh_part(Kind::mesh, slab(0.03125f)),
                               field_part(height_field(41, 0.05f, [](float, float) { return 0.0f; }))};
  for (const RigidPart& ground : grounds) {
    DeviceWorld d;
    d.world.add_fixed(fixed_solid(ground));
    for (int k = 0; k < 4; ++k)
      d.world.add_body(
          sleepless(body_def({shapes[k]}, {{0.3f * static_cast<float>(k) - 0.5f, half + 0.03f, 0.013f},
                                           k == 2 ? about({1, 0, 0}, pi / 2) : no_turn})));
    run(d.world, dt, 400);
    for (uint32_t n = 0; n < 4; ++n) {
      EXPECT_NEAR(d.world.pose(n).position.y, half, 0.0005f) << n;
      EXPECT_LT(length(d.world.velocity(n)), 0.002f) << n;
    }
  }
}

// Seams between triangles of one plane must not be felt.
TEST(RigidGround, SlidingStopsAfterTheRightWay) {
  for (const float cell : {2.0f, 0.0625f}) {
    DeviceWorld d;
    d.world.add_fixed(fixed_solid(mesh_part(Kind::mesh, slab(cell)), {{0, 0, 0}, about({0, 1, 0}, 0.3f)}));
    for (const int k : {0, 3}) {
      RigidBodyDef def = body_def({shapes[k]}, {{-0.5f, half, k ? 0.3f : -0.3f}, no_turn});
      def.solid.friction = 0.5f;
      def.velocity = {2.2f, 0, 0};
      d.world.add_body(def);
    }
    run(d.world, 0.001f, 800);
    const float way = 2.2f * 2.2f / (2 * 9.81f * 0.5f);
    for (uint32_t n = 0; n < 2; ++n) {
      EXPECT_NEAR(d.world.pose(n).position.x, way - 0.5f, 0.01f * way) << n;
      EXPECT_NEAR(d.world.pose(n).position.y, half, 0.0005f) << n;
    }
  }
}

TEST(RigidGround, ABallRollsOverSeams) {
  DeviceWorld d;
  d.world.add_fixed(fixed_solid(mesh_part(Kind::mesh, slab(0.0625f))));
  RigidBodyDef def = body_def({shapes[1]}, {{-0.9f, half, 0.11f}, no_turn});
  def.velocity = {1, 0, 0.2f};
  def.angular_velocity = {0.2f / half, 0, -1 / half};
  d.world.add_body(def);
  float highest = 0;
  for (int i = 0; i < 350; ++i) {
    d.world.step(dt, {});
    highest = std::max(highest, d.world.pose(0).position.y);
  }
  EXPECT_LT(highest, half + 0.0005f);
  EXPECT_NEAR(d.world.velocity(0).x, 1, 0.01f);
  EXPECT_NEAR(d.world.velocity(0).z, 0.2f, 0.01f);
}

// Vertices of the first are beyond the slabs, and of the second on a side of one.
TEST(RigidGround, APlankLiesAcrossEdges) {
  const RigidPart plank = box_part({0.6f, 0.02f, 0.05f});
  DeviceWorld d;
  for (const float x : {-0.3f, 0.3f})
    d.world.add_fixed(
        fixed_solid(mesh_part(Kind::mesh, box_mesh({x - 0.05f, -0.5f, -1}, {x + 0.05f, 0, 1}))));
  d.world.add_body(sleepless(body_def({plank}, {{0.02f, 0.03f, 0}, about({0, 1, 0}, 0.2f)})));
  // A quarter of it overhangs.
  d.world.add_body(sleepless(body_def({plank}, {{0.3f, 0.02f, 0.7f}, about({0, 1, 0}, pi / 2)})));
  run(d.world, dt, 500);
  EXPECT_NEAR(d.world.pose(0).position.y, 0.02f, 0.001f);
  EXPECT_LT(length(d.world.velocity(0)), 0.002f);
  EXPECT_NEAR(d.world.pose(1).position.y, 0.02f, 0.001f);
  EXPECT_LT(length(d.world.velocity(1)), 0.002f);
}

TEST(RigidGround, APlankLiesFlushOnABlock) {
  for (const float turn : {0.0f, 0.3f, 1.1f}) {
    for (const int k : {0, 3}) {
      DeviceWorld d;
      const Pose under{{0.1f, -half, 0.2f}, about({0, 1, 0}, turn)};
      d.world.add_fixed(
          fixed_solid(mesh_part(Kind::mesh, box_mesh({-half, -half, -half}, {half, half, half})), under));
      d.world.add_body(sleepless(body_def({shapes[k]}, {{0.1f, half, 0.2f}, under.rotation})));
      run(d.world, dt, 500);
      EXPECT_LT(length(d.world.pose(0).position - Vec3{0.1f, half, 0.2f}), 0.001f) << turn;
      EXPECT_LT(length(d.world.velocity(0)), 0.001f) << turn;
    }
  }
}

// A flat bottom on three tips.
TEST(RigidGround, ABoxRestsOnTips) {
  DeviceWorld d;
  for (const Vec3 at : {Vec3{-0.1f, 0, -0.08f}, Vec3{0.1f, 0, -0.08f}, Vec3{0, 0, 0.1f}}) {
    TriangleMesh tip{{{0, 0, 0},
                      {0.03f, -0.1f, 0.03f},
                      {0.03f, -0.1f, -0.03f},
                      {-0.03f, -0.1f, -0.03f},
                      {-0.03f, -0.1f, 0.03f}},
                     {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {1, 4, 2}, {2, 4, 3}}};
    d.world.add_fixed(fixed_solid(mesh_part(Kind::mesh, tip), {at, no_turn}));
  }
  d.world.add_body(sleepless(body_def({box_part({0.2f, 0.03f, 0.2f})}, {{0, 0.035f, 0}, no_turn})));
  run(d.world, dt, 400);
  EXPECT_NEAR(d.world.pose(0).position.y, 0.03f, 0.001f);
  EXPECT_LT(length(d.world.velocity(0)), 0.002f);
}

// An edge across a ridge at a right angle: upright at first, it tips over either way, and does not pass.
TEST(RigidGround, AnEdgeStopsAtARidge) {
  DeviceWorld d({.gravity = {0, 0, 0}, .on_device = true});
  const TriangleMesh ridge{
      {{-0.3f, -0.3f, -1}, {0.3f, -0.3f, -1}, {0, 0, -1}, {-0.3f, -0.3f, 1}, {0.3f, -0.3f, 1}, {0, 0, 1}},
      {{0, 2, 1}, {3, 4, 5}, {0, 3, 5}, {0, 5, 2}, {1, 2, 5}, {1, 5, 4}, {0, 1, 4}, {0, 4, 3}}};
  d.world.add_fixed(fixed_solid(mesh_part(Kind::mesh, ridge)));
  const float diagonal = std::sqrt(2.0f) * half;
  RigidBodyDef def = body_def({shapes[0]}, {{0, diagonal + 0.02f, 0.013f}, about({1, 0, 0}, pi / 4)});
  def.velocity = {0, -1, 0};
  d.world.add_body(def);
  float lowest = 1;
  for (int i = 0; i < 100; ++i) {
    d.world.step(dt, {});
    lowest = std::min(lowest, d.world.pose(0).position.y);
  }
  EXPECT_GT(lowest, diagonal - 0.002f);
}

TEST(RigidGround, ABoxInACornerRestsAtThreeWalls) {
  // The inside of a box: a mesh whose faces look inwards, closed by an outer one.
  DeviceWorld d;
  const Vec3 wall{0.5f, 0.5f, 0.5f};
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 at = -0.5f * unit_axis(axis);
    d.world.add_fixed(fixed_solid(mesh_part(Kind::mesh, box_mesh(-wall, wall)), {at, no_turn}));
  }
  for (int k = 0; k < 2; ++k) {
    RigidBodyDef def = body_def(
        {shapes[k]}, {{half + 0.02f + 0.3f * static_cast<float>(k), half + 0.05f, half + 0.02f}, no_turn});
    def.velocity = {k ? 0 : -0.5f, 0, -0.5f};
    d.world.add_body(sleepless(def));
  }
  run(d.world, dt, 400);
  EXPECT_NEAR(d.world.pose(0).position.y, half, 0.001f);
  EXPECT_GE(d.world.pose(0).position.x, half - 0.001f);
  EXPECT_GE(d.world.pose(0).position.z, half - 0.001f);
  EXPECT_GE(d.world.pose(1).position.z, half - 0.001f);
}

// A ball of radius r in a valley with slopes of 45° rests on both, √2 r above its line.
TEST(RigidGround, ABallRestsInAValley) {
  DeviceWorld d;
  d.world.add_fixed(
      fixed_solid(field_part(height_field(21, 0.1f, [](float x, float) { return std::fabs(x); }))));
  d.world.add_body(sleepless(body_def({shapes[1]}, {{0.02f, 0.12f, 0.03f}, no_turn})));
  run(d.world, dt, 800);
  EXPECT_NEAR(d.world.pose(0).position.y, std::sqrt(2.0f) * half, 0.0005f);
  EXPECT_NEAR(d.world.pose(0).position.x, 0, 0.0005f);
  EXPECT_LT(length(d.world.velocity(0)), 0.002f);
}

TEST(RigidGround, AStackOf6StandsOnAMesh) {
  DeviceWorld d;
  d.world.add_fixed(fixed_solid(mesh_part(Kind::mesh, slab(0.0625f))));
  for (int k = 0; k < 6; ++k)
    d.world.add_body(sleepless(
        body_def({shapes[k % 2 ? 0 : 3]}, {{0, half * (2.0f * static_cast<float>(k) + 1), 0}, no_turn})));
  run(d.world, dt, 1500);
  for (uint32_t n = 0; n < 6; ++n) {
    EXPECT_NEAR(d.world.pose(n).position.y, half * (2.0f * static_cast<float>(n) + 1), 0.001f) << n;
    EXPECT_LT(length(d.world.velocity(n)), 0.001f) << n;
  }
}

TEST(RigidGround, AKinematicMeshCarriesBodies) {
  DeviceWorld d;
  const uint32_t tray = d.world.add_body(kinematic_def({mesh_part(Kind::mesh, slab(0.125f))}, {}));
  const uint32_t box = d.world.add_body(body_def({shapes[0]}, {{0.1f, half, 0}, no_turn}));
  run(d.world, dt, 25);
  d.world.move(tray, {{0.2f, 0.1f, 0}, no_turn}, 1);
  run(d.world, dt, 250);
  EXPECT_NEAR(d.world.pose(box).position.x, 0.3f, 0.005f);
  EXPECT_NEAR(d.world.pose(box).position.y, 0.1f + half, 0.001f);
}

TEST(RigidGround, TheSameBitsAgain) {
  const tests::ManyThreads many;
  std::vector<uint64_t> hashes;
  for (const int threads : {1, 8}) {
    DeviceWorld d({.on_device = true}, threads);
    d.world.add_fixed(fixed_solid(mesh_part(Kind::mesh, slab(0.0625f))));
    drop_jumble(d.world, 60);
    run(d.world, dt, 60);
    const RigidWorld::SnapshotPtr saved = RigidWorld::make_snapshot();
    d.world.save(*saved);
    run(d.world, dt, 40);
    hashes.push_back(hash_of(d.world));
    d.world.restore(*saved);
    run(d.world, dt, 40);
    hashes.push_back(hash_of(d.world));
  }
  for (const uint64_t hash : hashes) EXPECT_EQ(hash, hashes[0]);
}

}  // namespace meniscus::collision
