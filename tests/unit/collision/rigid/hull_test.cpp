// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Hulls as a device's contacts see them: their faces, and manifolds against exact distances.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "collision/rigid_contact/hull_buffers.h"
#include "collision/rigid_contact/touch.h"
#include "pbd/device/cpu/cpu_device.h"
#include "tests/unit/collision/rigid/device_scene.h"

namespace meniscus::collision {

namespace {

constexpr float pi = 3.14159265f;

std::vector<Vec3> box_points(Vec3 half, Quat turn = no_turn) {
  std::vector<Vec3> points;
  for (int k = 0; k < 8; ++k)
    points.push_back(
        rotate(turn, {k & 1 ? half.x : -half.x, k & 2 ? half.y : -half.y, k & 4 ? half.z : -half.z}));
  return points;
}

std::vector<Vec3> prism_points(int sides, float radius, float half_height) {
  std::vector<Vec3> points;
  for (int k = 0; k < sides; ++k) {
    const float turn = 2 * pi * static_cast<float>(k) / static_cast<float>(sides);
    for (const float y : {-half_height, half_height})
      points.push_back({radius * std::cos(turn), y, radius * std::sin(turn)});
  }
  return points;
}

std::vector<Vec3> ball_points(int count) {
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    const float z = 1 - (2 * static_cast<float>(i) + 1) / static_cast<float>(count), r = std::sqrt(1 - z * z);
    const float turn = 2.39996323f * static_cast<float>(i);
    points.push_back({r * std::cos(turn), r * std::sin(turn), z});
  }
  return points;
}

/// Hulls in a table, as kernels see them.
struct Hulls {
  pbd::CpuDevice device{1};
  HullBuffers buffers{device};
  std::vector<Convex> parts;

  explicit Hulls(const std::vector<std::vector<Vec3>>& points) {
    std::vector<std::shared_ptr<const ContactHull>> hulls;
    for (const auto& own : points) {
      const auto hull = std::make_shared<const ContactHull>(make_contact_hull(own));
      Convex part{ConvexKind::hull, hull->half, static_cast<uint32_t>(hulls.size()), hull->radius};
      part.table = HullBuffers::number_of(part);
      parts.push_back(part);
      hulls.push_back(hull);
    }
    buffers.set(hulls);
  }
  Manifold touch(const Pose& a, const Convex& of_a, const Pose& b, const Convex& of_b, float reach) const {
    return touch_hull(buffers.table(), a, of_a, b, of_b, reach);
  }
};

float least_distance(const Manifold& m) {
  float least = 1e30f;
  for (uint32_t k = 0; k < m.count; ++k) least = std::min(least, m.points[k].distance);
  return least;
}

bool is_closed(const ContactHull& hull) {
  return hull.vertices.size() + hull.faces.size() == hull.edges.size() + 2;  // Euler
}

}  // namespace

TEST(RigidHull, ARoundedBoxHasSixFaces) {
  for (int k = 0; k < 40; ++k) {
    const Quat turn = about(normalized_or({0.3f, 0.1f * static_cast<float>(k), -0.7f}, {1, 0, 0}),
                            0.17f * static_cast<float>(k));
    const ContactHull hull = make_contact_hull(box_points({0.3f, 0.1f, 0.2f}, turn));
    EXPECT_EQ(hull.faces.size(), 6u) << k;
    EXPECT_EQ(hull.vertices.size(), 8u) << k;
    EXPECT_TRUE(is_closed(hull)) << k;
  }
}

TEST(RigidHull, ManyPointsAreReducedByLittle) {
  const ContactHull hull = make_contact_hull(ball_points(1000));
  EXPECT_LE(hull.vertices.size(), most_hull_vertices);
  EXPECT_GT(hull.vertices.size(), most_hull_vertices / 2);
  EXPECT_TRUE(is_closed(hull));
  EXPECT_GT(hull.error, 0);
  EXPECT_LT(hull.error, 0.06f);
  EXPECT_EQ(make_contact_hull(prism_points(32, 1, 0.2f)).error, 0);
}

// Hulls of boxes have the manifolds of boxes: the same normal, distance and number of points.
TEST(RigidHull, HullsOfBoxesTouchAsBoxesDo) {
  const Vec3 half{0.1f, 0.15f, 0.07f}, other{0.2f, 0.05f, 0.12f};
  const Hulls hulls({box_points(half), box_points(other)});
  const Convex box{ConvexKind::box, half}, second{ConvexKind::box, other};
  std::mt19937 random(7);
  std::uniform_real_distribution<float> any(-1, 1);
  int touching = 0;
  for (int k = 0; k < 3000; ++k) {
    const auto turn = [&] {
      return about(normalized_or({any(random), any(random), any(random)}, {1, 0, 0}), pi * any(random));
    };
    const Pose a{{0.25f * any(random), 0.25f * any(random), 0.25f * any(random)}, turn()},
        b{{0, 0, 0}, turn()};
    const Manifold exact = touch(a, box, b, second, 0.01f);
    for (const Convex& of_b : {hulls.parts[1], second}) {
      const Manifold m = hulls.touch(a, hulls.parts[0], b, of_b, 0.01f);
      // Where two axes are equally far, either may be chosen.
      ASSERT_NEAR(least_distance(m), least_distance(exact), 0.003f) << k;
      ASSERT_EQ(m.count > 0, exact.count > 0) << k;
      if (exact.count == 0 || dot(m.normal, exact.normal) < 0.9999f) continue;
      ++touching;
      ASSERT_EQ(m.count, exact.count) << k;
    }
  }
  EXPECT_GT(touching, 2000);
}

// A tip on a face, an edge across an edge, and a face on a face.
TEST(RigidHull, HullsHaveTheirDistance) {
  const Hulls hulls({{{0, -0.1f, 0}, {0.1f, 0.1f, 0.1f}, {-0.1f, 0.1f, 0.1f}, {0, 0.1f, -0.1f}},
                     prism_points(6, 0.2f, 0.1f)});
  const Convex &tip = hulls.parts[0], &prism = hulls.parts[1];
  for (const float gap : {-0.01f, 0.004f}) {
    const Manifold point = hulls.touch({{0.02f, 0.2f + gap, 0.01f}, no_turn}, tip, {}, prism, 0.01f);
    ASSERT_EQ(point.count, 1u);
    EXPECT_NEAR(point.normal.y, 1, 1e-5f);
    EXPECT_NEAR(point.points[0].distance, gap, 1e-5f);
    EXPECT_NEAR(point.points[0].position.x, 0.02f, 1e-5f);
    const Manifold face =
        hulls.touch({{0.03f, 0.2f + gap, 0}, about({0, 1, 0}, 0.4f)}, prism, {}, prism, 0.01f);
    ASSERT_EQ(face.count, 4u);
    for (const ManifoldPoint& p : face.points) EXPECT_NEAR(p.distance, gap, 1e-5f);
    // Lying prisms, one across the other: edges that cross at right angles.
    const Quat lying = about({1, 0, 0}, pi / 2), across = about({0, 1, 0}, pi / 2) * lying;
    const Manifold edge = hulls.touch({{0.03f, 0.4f + gap, 0.01f}, across * about({0, 1, 0}, pi / 6)}, prism,
                                      {{0, 0, 0}, lying * about({0, 1, 0}, pi / 6)}, prism, 0.01f);
    ASSERT_EQ(edge.count, 1u);
    EXPECT_NEAR(edge.points[0].distance, gap, 1e-4f);
    EXPECT_NEAR(edge.normal.y, 1, 1e-3f);
  }
}

TEST(RigidHull, RoundPartsHaveTheirDistance) {
  const Hulls hulls({box_points({0.1f, 0.1f, 0.1f})});
  const Convex ball{ConvexKind::sphere, {0.05f, 0, 0}}, box{ConvexKind::box, {0.1f, 0.1f, 0.1f}};
  std::mt19937 random(3);
  std::uniform_real_distribution<float> any(-0.2f, 0.2f);
  for (int k = 0; k < 500; ++k) {
    const Pose at{{any(random), any(random), any(random)}, no_turn};
    const Manifold exact = touch(at, ball, {}, box, 0.1f),
                   m = hulls.touch(at, ball, {}, hulls.parts[0], 0.1f);
    const Manifold turned = hulls.touch({}, hulls.parts[0], at, ball, 0.1f);
    ASSERT_EQ(m.count, exact.count);
    ASSERT_EQ(turned.count, exact.count);
    if (!m.count) continue;
    ASSERT_NEAR(m.points[0].distance, exact.points[0].distance, 1e-5f);
    ASSERT_NEAR(dot(m.normal, exact.normal), 1, 1e-4f);
    ASSERT_NEAR(dot(turned.normal, exact.normal), -1, 1e-4f);
  }
}

TEST(RigidHull, ACapsuleLiesOnAFaceAtTwoPoints) {
  const Hulls hulls({box_points({0.1f, 0.1f, 0.1f})});
  const Convex capsule{ConvexKind::capsule, {0.05f, 0.3f, 0}};
  for (const float gap : {-0.002f, 0.003f}) {
    // It overhangs the face on both sides.
    const Manifold m =
        hulls.touch({{0.04f, 0.15f + gap, 0}, about({0, 0, 1}, pi / 2)}, capsule, {}, hulls.parts[0], 0.01f);
    ASSERT_EQ(m.count, 2u);
    EXPECT_NEAR(std::fabs(m.points[0].position.x), 0.1f, 1e-5f);
    EXPECT_NEAR(m.points[0].position.x + m.points[1].position.x, 0, 1e-5f);
    for (uint32_t k = 0; k < 2; ++k) EXPECT_NEAR(m.points[k].distance, gap, 1e-5f);
    const Manifold across = hulls.touch({{0.14f + gap, 0.14f + gap, 0}, about({0, 0, 1}, pi / 4)}, capsule,
                                        {}, hulls.parts[0], 0.05f);
    EXPECT_NEAR(least_distance(across), std::sqrt(2.0f) * (0.04f + gap) - 0.05f, 1e-5f);
  }
}

// A tetrahedron falls in each of 24 ways, and comes to rest on a face.
TEST(RigidHull, TetrahedraComeToRestOnFaces) {
  const std::vector<Vec3> points{
      {0.1f, 0.1f, 0.1f}, {-0.1f, -0.1f, 0.1f}, {-0.1f, 0.1f, -0.1f}, {0.1f, -0.1f, -0.1f}};
  DeviceWorld d;
  d.world.add_fixed(fixed_solid(box_part({5, 0.1f, 5}), {{0, -0.1f, 0}, no_turn}));
  for (int k = 0; k < 24; ++k) {
    RigidBodyDef def = body_def({mesh_part(Kind::hull, hull_mesh(points))},
                                {{0.5f * static_cast<float>(k % 5), 0.2f, 0.5f * static_cast<float>(k / 5)},
                                 about({0.6f, 0, 0.8f}, 0.5f * static_cast<float>(k))});
    def.can_sleep = false;
    d.world.add_body(def);
  }
  run(d.world, 0.004f, 1000);
  const float height = 0.1f / std::sqrt(3.0f);  // of the centre above a face
  for (uint32_t n = 0; n < 24; ++n) {
    EXPECT_NEAR(d.world.pose(n).position.y, height, 0.001f) << n;
    EXPECT_LT(length(d.world.velocity(n)), 0.001f) << n;
  }
}

// A body of two hulls, an L, with a ball on its foot.
TEST(RigidHull, SolidsOfSeveralHullsRest) {
  RigidPart foot = mesh_part(Kind::hull, box_mesh({0, 0, -0.1f}, {0.4f, 0.05f, 0.1f}));
  const RigidPart back = mesh_part(Kind::hull, box_mesh({0, 0.05f, -0.1f}, {0.05f, 0.3f, 0.1f}));
  DeviceWorld d;
  d.world.add_fixed(fixed_solid(plane_part()));
  const uint32_t body = d.world.add_body(body_def({foot, back}, {{0, 0.01f, 0}, no_turn}));
  const uint32_t ball = d.world.add_body(body_def(round_part(Kind::sphere, 0.05f), {0.2f, 0.2f, 0}));
  run(d.world, 0.004f, 500);
  EXPECT_NEAR(d.world.pose(body).position.y, 0, 0.001f);
  EXPECT_NEAR(d.world.pose(ball).position.y, 0.1f, 0.001f);
}

TEST(RigidHull, APrismOf16SidesRests) {
  DeviceWorld d;
  d.world.add_fixed(fixed_solid(plane_part()));
  const RigidPart prism = mesh_part(Kind::hull, hull_mesh(prism_points(16, 0.1f, 0.05f)));
  for (int k = 0; k < 6; ++k) {
    RigidBodyDef def = body_def(prism, {0, 0.05f * (2 * static_cast<float>(k) + 1), 0});
    def.can_sleep = false;
    d.world.add_body(def);
  }
  run(d.world, 0.004f, 1000);
  for (uint32_t n = 0; n < 6; ++n) {
    EXPECT_NEAR(d.world.pose(n).position.y, 0.05f * (2 * static_cast<float>(n) + 1), 0.001f) << n;
    EXPECT_LT(length(d.world.velocity(n)), 0.0005f) << n;
  }
}

}  // namespace meniscus::collision
