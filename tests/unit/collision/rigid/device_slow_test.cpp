// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Structures of many solids that must stand for a minute, with contacts that a device solves. With Bullet a
// stack stands as well; the others creep or fall (docs/methods/rigid-contacts.md).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/unit/collision/rigid/solvers.h"

namespace meniscus::collision {

namespace {

constexpr float dt = 0.004f, half = 0.05f;

/// Boxes on a plane.
struct Structure {
  SolverWorld world;
  std::vector<Vec3> start;

  explicit Structure(Solver solver = Solver::device) : world(solver) {
    world.add_fixed(fixed_solid(plane_part()));
  }
  void add(Vec3 half_extents, const Pose& pose, double density = 1000) {
    RigidBodyDef def = body_def({box_part(half_extents)}, pose, density);
    def.can_sleep = false;
    world.add_body(def);
    start.push_back(pose.position);
  }
  std::vector<Vec3> places() const {
    std::vector<Vec3> all;
    for (uint32_t n = 0; n < start.size(); ++n) all.push_back(world.pose(n).position);
    return all;
  }

  /// No body sinks by a hundredth of the height, or creeps by a millimetre once the structure has settled.
  void expect_stands(float height) {
    run(world, dt, 2500);
    const std::vector<Vec3> settled = places();
    run(world, dt, 12500);
    const std::vector<Vec3> end = places();
    for (size_t n = 0; n < start.size(); ++n) {
      EXPECT_LT(std::fabs(end[n].y - start[n].y), 0.01f * height) << n;
      EXPECT_LT(length(end[n] - settled[n]), 0.001f) << n;
    }
  }
};

/// Two cards that lean on each other, on a surface at `y`.
void add_tent(Structure& structure, float x, float y) {
  constexpr float lean = 0.35f;
  const Vec3 card{0.002f, 0.065f, 0.045f};
  const float up = card.y * std::cos(lean) + card.x * std::sin(lean);
  const float aside = card.y * std::sin(lean) + card.x * std::cos(lean);
  for (const float side : {-1.0f, 1.0f})
    structure.add(card, {{x - side * aside, y + up, 0}, about({0, 0, 1}, -side * lean)}, 700);
}

}  // namespace

class RigidStack : public OnSolver {};
MENISCUS_WITH_EACH_SOLVER(RigidStack);

TEST_P(RigidStack, Of10Stands) {
  Structure stack(GetParam());
  for (int k = 0; k < 10; ++k)
    stack.add({half, half, half}, {{0, half * (2.0f * static_cast<float>(k) + 1), 0}, no_turn});
  stack.expect_stands(1);
}

TEST(RigidDeviceSlow, AWallOf10RowsOf20BricksStands) {
  constexpr float apart = 0.201f;
  const Vec3 brick{0.1f, half, half}, end{half, half, half};
  Structure wall;
  for (int row = 0; row < 10; ++row) {
    const float y = half * (2.0f * static_cast<float>(row) + 1);
    const int count = row % 2 ? 19 : 20;
    for (int k = 0; k < count; ++k)
      wall.add(brick, {{apart * (static_cast<float>(k) + (row % 2 ? 0.5f : 0)), y, 0}, no_turn});
    if (row % 2 == 0) continue;
    wall.add(end, {{-0.25f * apart, y, 0}, no_turn});
    wall.add(end, {{19.25f * apart, y, 0}, no_turn});
  }
  wall.expect_stands(1);
}

TEST(RigidDeviceSlow, APyramidOf210Stands) {
  Structure pyramid;
  for (int row = 0; row < 20; ++row) {
    for (int k = 0; k < 20 - row; ++k) {
      const float x = 2.1f * half * (static_cast<float>(k) + 0.5f * static_cast<float>(row));
      pyramid.add({half, half, half}, {{x, half * (2.0f * static_cast<float>(row) + 1), 0}, no_turn});
    }
  }
  pyramid.expect_stands(2);
}

TEST(RigidDeviceSlow, AHouseOfCardsStands) {
  Structure house;
  add_tent(house, 0, 0);
  add_tent(house, 0.12f, 0);
  const float y = 2 * (0.065f * std::cos(0.35f) + 0.002f * std::sin(0.35f));
  house.add({0.065f, 0.002f, 0.045f}, {{0.06f, y + 0.002f, 0}, no_turn}, 700);
  add_tent(house, 0.06f, y + 0.004f);
  house.expect_stands(0.25f);
}

}  // namespace meniscus::collision
