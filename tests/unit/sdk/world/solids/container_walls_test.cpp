// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A container's faces as boxes for Bullet, and which bodies they stop or let through.
#include "sdk/world/solids/container_walls.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/rigid_solvers.h"
#include "tests/unit/collision/mesh_shapes.h"
#include "tests/unit/sdk/world/solids/body_worlds.h"

namespace meniscus::tests {
namespace {

using collision::Noise;
using collision::RigidPart;

constexpr Vec3 half{1, 2, 0.5f};

int boxes_at(const std::vector<RigidPart>& walls, Vec3 p) {
  return static_cast<int>(std::count_if(walls.begin(), walls.end(), [&](const RigidPart& wall) {
    EXPECT_EQ(wall.kind, RigidPart::Kind::box);
    return max_component(abs(p - wall.pose.position) - wall.size) <= 0;
  }));
}

/// A point just behind a face, at shares −1 to 1 of the face's two other axes.
Vec3 behind(int face, float u, float v) {
  float p[3] = {half.x, half.y, half.z};
  const int axis = face / 2;
  p[axis] *= face % 2 ? 1.001f : -1.001f;
  p[(axis + 1) % 3] *= u;
  p[(axis + 2) % 3] *= v;
  return {p[0], p[1], p[2]};
}

TEST(ContainerWallsTest, AClosedContainerHasAWallBehindEachPointOfItsFacesAndNoneInside) {
  const auto walls = container_walls({half, {}});
  EXPECT_EQ(walls.size(), 6u);
  Noise noise(1);
  for (int n = 0; n < 2000; ++n) {
    const Vec3 r = noise.in_cube(1);
    EXPECT_EQ(boxes_at(walls, {0.999f * r.x * half.x, 0.999f * r.y * half.y, 0.999f * r.z * half.z}), 0);
    EXPECT_GE(boxes_at(walls, behind(n % 6, r.x, r.y)), 1);
  }
}

TEST(ContainerWallsTest, TheCornersAreClosedOutside) {
  const auto walls = container_walls({half, {}});
  for (int c = 0; c < 8; ++c) {
    const Vec3 corner{c & 1 ? half.x : -half.x, c & 2 ? half.y : -half.y, c & 4 ? half.z : -half.z};
    EXPECT_GE(boxes_at(walls, 1.01f * corner), 1);
    EXPECT_GE(boxes_at(walls, 1.5f * corner), 1);
  }
}

TEST(ContainerWallsTest, AnOpenFaceHasNoWall) {
  for (int face = 0; face < 6; ++face) {
    const auto walls = container_walls({half, {{static_cast<Face>(face), {}}}});
    EXPECT_EQ(walls.size(), 5u);
    Noise noise(2);
    for (int n = 0; n < 200; ++n) {
      const Vec3 r = noise.in_cube(0.99f);
      EXPECT_EQ(boxes_at(walls, behind(face, r.x, r.y)), 0);
      EXPECT_GE(boxes_at(walls, behind((face + 1 + n % 5) % 6, r.x, r.y)), 1);
    }
  }
}

// Two holes that overlap, and one that reaches beyond the face's edge.
TEST(ContainerWallsTest, AWallIsWhereNoHoleIs) {
  const std::vector<Aabb> holes{{{-0.5f, -9, -0.2f}, {0.1f, -9, 0.1f}},
                                {{-0.2f, 5, -0.1f}, {0.6f, 5, 0.3f}},
                                {{0.8f, 0, -0.4f}, {3, 0, -0.3f}}};
  ContainerGeometry container{half, {}};
  for (const Aabb& hole : holes) container.openings.push_back({Face::y_low, hole});
  const auto walls = container_walls(container);
  Noise noise(3);
  int in_holes = 0;
  for (int n = 0; n < 5000; ++n) {
    const Vec3 r = noise.in_cube(1), p{r.x * half.x, -1.001f * half.y, r.z * half.z};
    const bool in_hole = std::any_of(holes.begin(), holes.end(), [&](const Aabb& h) {
      return p.x > h.lower.x && p.x < h.upper.x && p.z > h.lower.z && p.z < h.upper.z;
    });
    EXPECT_EQ(boxes_at(walls, p) > 0, !in_hole) << p.x << ' ' << p.z;
    EXPECT_GE(boxes_at(walls, {p.x, 1.001f * half.y, p.z}), 1);
    in_holes += in_hole;
  }
  EXPECT_GT(in_holes, 300);
}

// The rectangles of one wall share only their edges: Bullet finds no contact twice.
TEST(ContainerWallsTest, TheRectanglesOfAWallDoNotOverlap) {
  ContainerGeometry container{half, {}};
  container.openings.push_back({Face::x_high, Aabb{{0, -1, -0.2f}, {0, 0.5f, 0.1f}}});
  container.openings.push_back({Face::x_high, Aabb{{0, 0.7f, 0.2f}, {0, 0.9f, 0.3f}}});
  const auto walls = container_walls(container);
  double area = 0;
  for (const RigidPart& wall : walls) {
    if (wall.pose.position.x > half.x) area += 4.0 * wall.size.y * wall.size.z;
  }
  const double whole = 4.0 * (half.y + 2) * (half.z + 2);  // walls reach past the corners by their thickness
  EXPECT_NEAR(area, whole - 1.5 * 0.3 - 0.2 * 0.1, 1e-4);
}

TEST(ContainerWallsTest, AHoleAsLargeAsAllItsWallLeavesNothing) {
  const auto walls = container_walls({half, {{Face::z_high, Aabb{{-99, -99, 0}, {99, 99, 0}}}}});
  EXPECT_EQ(walls.size(), 5u);
}

class ContainerFallTest : public WithSolver {};

// The hole is 0.5 m wide.
TEST_P(ContainerFallTest, ABallFallsThroughAHoleAndRestsBesideIt) {
  for (bool moves : {false, true}) {
    World world(world_def(GetParam(), 0.05f));
    const ContainerGeometry box{{1, 1, 1}, {{Face::y_low, Aabb{{-0.25f, 0, -0.25f}, {0.25f, 0, 0.25f}}}}};
    if (moves)
      world.create_body(kinematic(box));
    else
      world.create_shape(shape(box));
    const BodyId through = world.create_body(body(SphereGeometry{0.2f}, {0, -0.5f, 0}));
    const BodyId beside = world.create_body(body(SphereGeometry{0.2f}, {0.6f, -0.5f, 0}));
    const BodyId too_large = world.create_body(body(BoxGeometry{{0.3f, 0.1f, 0.3f}}, {0, 0.5f, 0}));
    run(world, 200, 0.01f);
    EXPECT_LT(world.body_state(through).pose.position.y, -3) << moves;
    EXPECT_NEAR(world.body_state(beside).pose.position.y, -0.8f, 0.01f) << moves;
    EXPECT_NEAR(world.body_state(too_large).pose.position.y, -0.9f, 0.01f) << moves;
  }
}

TEST_P(ContainerFallTest, AllFacesHoldABallThatIsThrownAbout) {
  WorldDef def = weightless(GetParam());
  World world(def);
  world.create_shape(shape(ContainerGeometry{{1, 1, 1}, {}}));
  BodyDef ball = body(SphereGeometry{0.1f});
  ball.surface.solid_restitution = 1;
  ball.velocity = {7, 11, 13};
  const BodyId id = world.create_body(ball);
  for (int k = 0; k < 200; ++k) {
    world.step(0.01f);
    ASSERT_LT(max_component(abs(world.body_state(id).pose.position)), 0.95f) << k;
  }
}

TEST_P(ContainerFallTest, ATurnedContainersHoleIsWhereItsFrameSays) {
  World world(world_def(GetParam(), 0.05f));
  ShapeDef def =
      shape(ContainerGeometry{{1, 1, 1}, {{Face::x_high, Aabb{{0, 0.2f, -0.4f}, {0, 0.8f, 0.4f}}}}});
  def.pose.rotation = about_z(-90);  // its x is down, its y is the world's x
  world.create_shape(def);
  const BodyId through = world.create_body(body(SphereGeometry{0.2f}, {0.5f, 0, 0}));
  const BodyId beside = world.create_body(body(SphereGeometry{0.2f}, {-0.5f, 0, 0}));
  run(world, 150, 0.01f);
  EXPECT_LT(world.body_state(through).pose.position.y, -3);
  EXPECT_NEAR(world.body_state(beside).pose.position.y, -0.8f, 0.01f);
}

MENISCUS_WITH_EACH_RIGID_SOLVER(ContainerFallTest);

}  // namespace
}  // namespace meniscus::tests
