// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Openings in a container's faces: which particles pass through them, and which do not.
#include <gtest/gtest.h>

#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

constexpr float s = 0.05f, radius = 0.5f * s;

class OpeningTest : public OnDevice {
 protected:
  World world_{make_def()};

  WorldDef make_def() const {
    WorldDef def = world_def(GetParam(), s);
    def.gravity = {0, 0, 0};
    return def;
  }

  /// A container from −1 to 1 with a hole of 0.6 × 0.6 m in the middle of its face x = 1.
  static ShapeDef holed() {
    ShapeDef def =
        shape(ContainerGeometry{{1, 1, 1}, {{Face::x_high, Aabb{{0, -0.3f, -0.3f}, {0, 0.3f, 0.3f}}}}});
    return def;
  }

  static World falling(pbd::DeviceKind kind) { return World(world_def(kind, s)); }

  void shoot(const std::vector<Vec3>& from, Vec3 velocity) {
    world_.add_particles(world_.create_fluid({}), from, std::vector<Vec3>(from.size(), velocity));
  }
};

TEST_P(OpeningTest, ThroughTheHoleAndOnlyThere) {
  world_.create_shape(holed());
  std::vector<Vec3> from;
  for (int n = 0; n < 81; ++n) from.push_back({0, 0.21f * (float(n % 9) - 4), 0.21f * (float(n / 9) - 4)});
  shoot(from, {4, 0, 0});
  run(world_, 60, 0.01f);
  for (size_t i = 0; i < from.size(); ++i) {
    const float off = std::max(std::fabs(from[i].y), std::fabs(from[i].z));
    const float x = world_.positions()[i].x;
    if (off < 0.3f) {
      EXPECT_NEAR(x, 2.4f, 0.02f) << off;
    } else {
      EXPECT_LT(x, 1) << off;
    }
  }
}

// Fast and at a slant: where the path meets the wall there is no hole, where it ends there would be one.
TEST_P(OpeningTest, AFastParticleMustMeetTheHoleAndNotJustItsShadow) {
  world_.create_shape(holed());
  const float reach = 20 * radius;  // of one substep of 2.5 ms
  const Vec3 velocity = reach / 0.0025f * normalized_or({1, -1, 0}, {1, 0, 0});
  shoot({{0.95f, 0.5f, 0}}, velocity);  // meets x = 1 at y = 0.45
  world_.step(0.01f);
  EXPECT_LT(world_.positions()[0].x, 1);
}

TEST_P(OpeningTest, TheHoleTurnsWithTheContainer) {
  ShapeDef def = holed();
  def.pose.position = {5, 0, 0};
  def.pose.rotation = about_z(90);  // its x is the world's y
  world_.create_shape(def);
  shoot({{5.2f, 0, 0}, {5.5f, 0, 0}}, {0, 4, 0});
  run(world_, 60, 0.01f);
  EXPECT_NEAR(world_.positions()[0].y, 2.4f, 0.02f);
  EXPECT_LT(world_.positions()[1].y, 1);
}

TEST_P(OpeningTest, AFaceMayBeOpenAltogether) {
  world_.create_shape(shape(ContainerGeometry{{1, 1, 1}, {{Face::y_high, {}}}}));
  shoot({{0.9f, 0, 0.9f}, {0, 0, 0}}, {0, 5, 0});
  run(world_, 50, 0.01f);
  for (Vec3 p : world_.positions()) EXPECT_NEAR(p.y, 2.5f, 0.02f);
}

TEST_P(OpeningTest, FluidRunsOutOfAHoleInTheFloorAndAwayBelow) {
  World world = falling(GetParam());
  world.create_shape(shape(
      ContainerGeometry{{0.3f, 0.5f, 0.3f}, {{Face::y_low, Aabb{{-0.1f, 0, -0.1f}, {0.1f, 0, 0.1f}}}}}));
  const size_t count =
      world.add_fluid(block(world.create_fluid({}), {-0.3f, -0.5f, -0.3f}, {0.3f, -0.2f, 0.3f}));
  run(world, 60, 0.016f);
  size_t left = 0;
  for (Vec3 p : world.positions()) left += p.y < -0.6f;
  EXPECT_GT(left, count / 4);
  EXPECT_EQ(world.diagnostics().outside, 0u);
}

// What has left through a side wall falls: the floor ends where the container ends.
TEST_P(OpeningTest, AJetFromTheSideFallsBelowTheFloor) {
  World world = falling(GetParam());
  world.create_shape(
      shape(ContainerGeometry{{0.5f, 0.5f, 0.5f}, {{Face::x_high, Aabb{{0, -0.5f, -0.2f}, {0, 0, 0.2f}}}}}));
  world.add_particles(world.create_fluid({}), std::vector<Vec3>{{0.3f, -0.3f, 0}},
                      std::vector<Vec3>{{5, 0, 0}});
  run(world, 60, 0.01f);
  EXPECT_GT(world.positions()[0].x, 1);
  EXPECT_LT(world.positions()[0].y, -1);
}

MENISCUS_ON_EACH_DEVICE(OpeningTest);

}  // namespace
}  // namespace meniscus::tests
