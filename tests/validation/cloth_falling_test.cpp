// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A sheet that starts stretched and sheared, and falls freely without air, comes to its rest shape.
#include "tests/validation/cloth_worlds.h"

namespace meniscus::tests {
namespace {

class ClothFalling : public OnDevice {
 protected:
  /// Let go at once, what was stretched by 1 % swings beyond its rest shape: twice as far where waves from
  /// two borders meet. From there on strain goes down, second by second.
  void expect_rest(StretchModel model, Vec3 stretch) {
    World world(cloth_world(GetParam(), 10, 10));
    ClothDef def = sheet(1, 1, 33, 33);
    def.fabric.density = 0.15f;
    def.fabric.stretch_model = model;
    def.stretch = stretch;
    const ClothId id = world.create_cloth(def);
    world.set_wind({.air_density = 0});
    const std::vector<Vec3> rest = at_rest(def);
    constexpr double rounding = 1e-5;
    double before = 0.03;
    for (int half_second = 0; half_second < 4; ++half_second) {
      double most = 0;
      for (int k = 0; k < 30; ++k) {
        world.step(frame);
        const std::vector<double> edges = edge_stretches(world, id, rest);
        most = std::max({most, 1 - edges.front(), edges.back() - 1});
      }
      EXPECT_LT(most, std::max(before, rounding)) << "half-second " << half_second;
      before = most;
      record("strain_" + std::to_string(half_second), most);
    }
    EXPECT_LT(before, 1e-4);
  }
};

TEST_P(ClothFalling, StretchedAlongBothAxes) {
  expect_rest(StretchModel::edges, {1.01f, 1, 1.01f});
}
TEST_P(ClothFalling, Sheared) {
  expect_rest(StretchModel::edges, {1.01f, 1, 0.99f});
}
TEST_P(ClothFalling, StretchedAlongBothAxesByTriangles) {
  expect_rest(StretchModel::triangles, {1.01f, 1, 1.01f});
}
TEST_P(ClothFalling, ShearedByTriangles) {
  expect_rest(StretchModel::triangles, {1.01f, 1, 0.99f});
}

MENISCUS_ON_EACH_DEVICE(ClothFalling);

}  // namespace
}  // namespace meniscus::tests
