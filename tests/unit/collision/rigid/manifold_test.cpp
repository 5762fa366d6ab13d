// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The contacts of pairs of convex parts, against their exact distances.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "collision/rigid_contact/touch.h"

namespace meniscus::collision {

namespace {

const Quat no_turn{0, 0, 0, 1};
const Convex cube{ConvexKind::box, {0.1f, 0.1f, 0.1f}};

float least_distance(const Manifold& m) {
  float least = 1e30f;
  for (uint32_t k = 0; k < m.count; ++k) least = std::min(least, m.points[k].distance);
  return least;
}

}  // namespace

TEST(RigidManifold, FlatBoxesTouchAtFourCorners) {
  for (const float gap : {-0.002f, 0.0f, 0.002f}) {
    const Manifold m = touch({{0.03f, 0.2f + gap, 0.01f}, rotation_by({0, 0.3f, 0})}, cube, {}, cube, 0.01f);
    ASSERT_EQ(m.count, 4u);
    EXPECT_NEAR(m.normal.y, 1, 1e-6f);
    std::set<uint32_t> features;
    for (const ManifoldPoint& p : m.points) {
      EXPECT_NEAR(p.distance, gap, 1e-6f);
      EXPECT_NEAR(p.position.y, 0.1f + 0.5f * gap, 1e-6f);
      features.insert(p.feature);
    }
    EXPECT_EQ(features.size(), 4u);
  }
}

// Two edges that cross at right angles, each turned by an eighth.
TEST(RigidManifold, TurnedBoxesHaveTheirDistance) {
  const float eighth = 0.78539816f, diagonal = 0.1f * std::sqrt(2.0f);
  const Pose lower{{0, 0, 0}, rotation_by({0, 0, eighth})};
  for (const float gap : {-0.003f, 0.004f}) {
    const Pose upper{{0.02f, 2 * diagonal + gap, -0.03f}, rotation_by({eighth, 0, 0})};
    const Manifold m = touch(upper, cube, lower, cube, 0.01f);
    ASSERT_EQ(m.count, 1u);
    EXPECT_NEAR(m.points[0].distance, gap, 1e-6f);
    EXPECT_NEAR(m.normal.y, 1, 1e-5f);
    EXPECT_NEAR(m.points[0].position.x, 0, 1e-5f);
    EXPECT_NEAR(m.points[0].position.z, -0.03f, 1e-5f);
  }
}

TEST(RigidManifold, RoundPartsHaveTheirDistance) {
  const Convex ball{ConvexKind::sphere, {0.05f, 0, 0}}, capsule{ConvexKind::capsule, {0.05f, 0.1f, 0}};
  const Pose corner{{0.1f + 0.04f, 0.1f + 0.04f, 0.1f + 0.02f}, no_turn};
  EXPECT_NEAR(least_distance(touch(corner, ball, {}, cube, 0.1f)), 0.06f - 0.05f, 1e-6f);
  const Manifold lying = touch({{0, 0.16f, 0}, rotation_by({0, 0, 1.5707963f})}, capsule, {}, cube, 0.02f);
  EXPECT_GE(lying.count, 2u);
  EXPECT_NEAR(least_distance(lying), 0.01f, 1e-5f);
  const Manifold crossed = touch({{0, 0.12f, 0}, rotation_by({0, 0, 1.5707963f})}, capsule,
                                 {{0, 0, 0}, rotation_by({1.5707963f, 0, 0})}, capsule, 0.1f);
  EXPECT_NEAR(least_distance(crossed), 0.02f, 1e-5f);
  EXPECT_NEAR(crossed.normal.y, 1, 1e-5f);
}

TEST(RigidManifold, TheSecondPartSeesTheOppositeNormal) {
  const Convex ball{ConvexKind::sphere, {0.05f, 0, 0}};
  const Pose above{{0, 0.14f, 0}, no_turn};
  EXPECT_NEAR(touch(above, ball, {}, cube, 0).normal.y, 1, 1e-6f);
  EXPECT_NEAR(touch({}, cube, above, ball, 0).normal.y, -1, 1e-6f);
}

}  // namespace meniscus::collision
