// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A sheet that falls on a ball, folds over it and on the floor around it, and does not pass through itself.
#include "tests/triangle_intersections.h"
#include "tests/validation/cloth_worlds.h"

namespace meniscus::tests {
namespace {

class ClothFolded : public OnDevice {
 protected:
  static size_t crossings(const World& world, ClothId id) {
    std::vector<TriangleIntersections::Triangle> triangles;
    const auto t = world.cloth_triangles(id);
    for (size_t k = 0; k < t.size(); k += 3) triangles.push_back({t[k], t[k + 1], t[k + 2]});
    return TriangleIntersections(world.cloth_positions(id), triangles).count();
  }
};

TEST_P(ClothFolded, OverABallAndOnTheFloor) {
  World world(cloth_world(GetParam(), 40, 1));
  ShapeDef ball = shape(SphereGeometry{0.25f}), floor = shape(PlaneGeometry{{0, 1, 0}, -0.3f});
  ball.surface.friction = floor.surface.friction = 0.5f;
  world.create_shape(ball);
  world.create_shape(floor);
  ClothDef def = sheet(1.2f, 1.2f, 60, 60, {0.02f, 0.3f, 0.01f});
  def.fabric.friction = 0.5f;
  def.pose.rotation = {0, std::sin(0.3f), 0, std::cos(0.3f)};
  const ClothId id = world.create_cloth(def);
  for (int second = 1; second <= 4; ++second) {
    run(world, 60, frame);
    EXPECT_EQ(crossings(world, id), 0u) << "after " << second << " s";
  }
  const double stretch = percentile(edge_stretches(world, id, at_rest(def)), 0.99);
  record("p99_stretch", stretch);
  record("rms_speed", rms_speed(world, id));
  EXPECT_LE(stretch, 1.02);
  EXPECT_LT(rms_speed(world, id), 0.02);
}

MENISCUS_ON_EACH_DEVICE(ClothFolded);

}  // namespace
}  // namespace meniscus::tests
