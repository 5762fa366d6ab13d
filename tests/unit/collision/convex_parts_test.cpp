// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the convex parts of solids.
#include "collision/mesh/convex_parts.h"

#include <gtest/gtest.h>

#include "collision/mesh/box_clip.h"
#include "collision/mesh/hull.h"
#include "collision/mesh/triangle_bvh.h"
#include "collision/mesh/triangle_bvh_query.h"
#include "tests/unit/collision/mesh_shapes.h"
#include "tests/unit/collision/turned_shapes.h"

namespace meniscus::collision {
namespace {

bool any_holds(const ConvexParts& parts, Vec3 p) {
  return std::ranges::any_of(parts.hulls, [&](const TriangleMesh& hull) {
    return std::ranges::all_of(hull.triangles, [&](const auto& t) {
      const Vec3 a = hull.vertices[t[0]], b = hull.vertices[t[1]], c = hull.vertices[t[2]];
      return dot(cross(b - a, c - a), p - a) < 1e-6f;
    });
  });
}

/// All of a solid is in its parts, and what they add is little.
void expect_cover(const TriangleMesh& mesh, const ConvexParts& parts, double excess) {
  const TriangleBvh bvh(mesh);
  const Aabb box = bounds(mesh);
  Noise noise(7);
  int inside = 0;
  for (int k = 0; k < 20000; ++k) {
    const Vec3 u = noise.in_cube(1), size = 0.5f * (box.upper - box.lower);
    const Vec3 p = 0.5f * (box.lower + box.upper) + Vec3{u.x * size.x, u.y * size.y, u.z * size.z};
    if (!is_inside(bvh.view(), p)) continue;
    ++inside;
    ASSERT_TRUE(any_holds(parts, p)) << p.x << ' ' << p.y << ' ' << p.z;
  }
  EXPECT_GT(inside, 100);
  double volume = 0;
  for (const TriangleMesh& hull : parts.hulls) volume += signed_volume(hull);
  const double own = signed_volume(mesh);
  EXPECT_NEAR(volume, own, excess * own);
  EXPECT_NEAR(parts.excess, volume - own, 0.01 * own);
  testing::Test::RecordProperty("parts", static_cast<int>(parts.hulls.size()));
  testing::Test::RecordProperty("excess_percent", std::to_string(100 * (volume / own - 1)));
}

TEST(VolumeWithin, BoxesOfABall) {
  const TriangleMesh ball = ball_mesh(1, 5);
  const double whole = signed_volume(ball);
  EXPECT_NEAR(volume_within(ball, {{-2, -2, -2}, {2, 2, 2}}), whole, 1e-6);
  EXPECT_NEAR(volume_within(ball, {{0, 0, 0}, {2, 2, 2}}), whole / 8, 1e-6);
  EXPECT_NEAR(volume_within(ball, {{-0.1, -0.2, -0.3}, {0.2, 0.3, 0.4}}), 0.3 * 0.5 * 0.7, 1e-6);
  EXPECT_NEAR(volume_within(ball, {{1.5, -2, -2}, {2, 2, 2}}), 0, 1e-9);
}

TEST(ConvexParts, AConvexMeshIsOne) {
  for (const TriangleMesh& mesh : {ball_mesh(0.3f, 3), box_mesh({-1, -2, 0}, {1, 2, 0.5f})}) {
    const ConvexParts parts = convex_parts(mesh, 32);
    ASSERT_EQ(parts.hulls.size(), 1u);
    EXPECT_NEAR(signed_volume(parts.hulls[0]), signed_volume(mesh), 1e-6);
  }
}

TEST(ConvexParts, ABowlIsOpen) {
  const TriangleMesh bowl = bowl_mesh(1, 0.9f);
  ASSERT_GT(signed_volume(bowl), 0);
  const ConvexParts parts = convex_parts(bowl, 32);
  expect_cover(bowl, parts, 0.5);
  for (const Vec3 p : {Vec3{0, 0, 0}, Vec3{0, -0.8f, 0}, Vec3{0.8f, -0.05f, 0}, Vec3{0.36f, -0.54f, 0.36f}})
    EXPECT_FALSE(any_holds(parts, p)) << p.x << ' ' << p.y << ' ' << p.z;
}

TEST(ConvexParts, ARingHasAHole) {
  const TriangleMesh ring = ring_mesh(1, 0.25f);
  ASSERT_GT(signed_volume(ring), 0);
  const ConvexParts parts = convex_parts(ring, 32);
  expect_cover(ring, parts, 0.1);
  for (const Vec3 p : {Vec3{0, 0, 0}, Vec3{0.65f, 0, 0}, Vec3{0.45f, 0, 0.45f}})
    EXPECT_FALSE(any_holds(parts, p)) << p.x << ' ' << p.y << ' ' << p.z;
}

TEST(ConvexParts, TheirNumberIsBounded) {
  EXPECT_EQ(convex_parts(ring_mesh(1, 0.1f), 1).hulls.size(), 1u);
  EXPECT_LE(convex_parts(ring_mesh(1, 0.1f), 5).hulls.size(), 5u);
}

}  // namespace
}  // namespace meniscus::collision
