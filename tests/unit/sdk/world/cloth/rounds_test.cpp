// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Several rounds over the stretch constraints in an iteration leave less stretch.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/cloth_worlds.h"

namespace meniscus::tests {
namespace {

class ClothRounds : public testing::TestWithParam<pbd::DeviceKind> {
 protected:
  /// The 99th percentile of all edges' stretch, of a sheet that has fallen over a ball.
  static double stretch_on_a_ball(int rounds, int iterations, float warm_start = 0) {
    WorldDef settings = world_def(GetParam(), 0.05f);
    settings.substeps = 8;
    settings.iterations = iterations;
    settings.cloth.stretch_rounds = rounds;
    settings.cloth.warm_start = warm_start;
    World world(settings);
    ShapeDef ball;
    ball.geometry = SphereGeometry{0.5f};
    world.create_shape(ball);
    ClothDef def = sheet(2, 2, 51, 51, {0, 0.6f, 0});
    def.self_collision = false;
    const ClothId id = world.create_cloth(def);
    const auto at_rest = world.cloth_positions(id);
    const std::vector<Vec3> rest(at_rest.begin(), at_rest.end());
    for (int k = 0; k < 60; ++k) world.step(1 / 60.0f);
    return percentile(edge_stretches(world, id, rest), 0.99) - 1;
  }
};

TEST_P(ClothRounds, LeaveLessStretchWhereClothDrapes) {
  const double one = stretch_on_a_ball(1, 1), four = stretch_on_a_ball(4, 1);
  EXPECT_GT(one, 0.01);
  EXPECT_LT(four, 0.6 * one);
}

/// They are the last iteration's.
TEST_P(ClothRounds, GoWithIterations) {
  EXPECT_LT(stretch_on_a_ball(3, 2), 0.6 * stretch_on_a_ball(1, 2));
}

/// Chains undo most of the pull of diagonals in each round. So it takes many rounds to accumulate, or many
/// substeps that each start from the last.
TEST_P(ClothRounds, AreSavedByAStartFromTheLastSubstep) {
  const double many = stretch_on_a_ball(8, 1), afresh = stretch_on_a_ball(1, 1),
               from_last = stretch_on_a_ball(1, 1, ClothSolverDef{}.warm_start);
  EXPECT_GT(afresh, 1.8 * many) << many;
  EXPECT_LT(from_last, 0.6 * afresh);
}

/// The pull of diagonals adds up faster by the momentum of their steps.
TEST_P(ClothRounds, GatherMomentum) {
  EXPECT_LT(stretch_on_a_ball(4, 1), 0.014);
}

/// Rows that slide along themselves, alternately, compress all diagonals of a sheet and stretch none. If
/// diagonals were soft in compression, cloth that has to become narrower would slide instead of buckling.
TEST_P(ClothRounds, KeepRowsFromSliding) {
  constexpr int n = 81;
  WorldDef settings = world_def(GetParam(), 0.05f);
  settings.substeps = 12;
  settings.cloth = {.warm_start = 0.8f, .stretch_rounds = 4};
  World world(settings);
  ShapeDef ball;
  ball.geometry = SphereGeometry{0.5f};
  world.create_shape(ball);
  const ClothId id = world.create_cloth(sheet(2, 2, n, n, {0, 0.6f, 0}));
  for (int k = 0; k < 30; ++k) world.step(1 / 60.0f);
  const auto x = world.cloth_positions(id);
  std::vector<float> slides;  // of a row against those beside it, in edges
  for (size_t v = n; v + n + 1 < x.size(); ++v) {
    if (v % n == n - 1) continue;
    const Vec3 along = x[v + 1] - x[v], bend = 0.5f * (x[v - n] + x[v + n]) - x[v];
    slides.push_back(std::fabs(dot(along, bend)) / dot(along, along));
  }
  std::sort(slides.begin(), slides.end());
  EXPECT_LT(slides[slides.size() * 3 / 4], 0.03f);
}

INSTANTIATE_TEST_SUITE_P(On, ClothRounds, testing::ValuesIn(usable_devices()),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace meniscus::tests
