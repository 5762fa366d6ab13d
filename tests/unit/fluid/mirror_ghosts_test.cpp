// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The effect of walls on the density, through the read-outs of a world.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

constexpr float s = 0.05f;

class MirrorGhostsTest : public OnDevice {
 protected:
  struct Found {
    std::vector<Vec3> positions;
    std::vector<float> errors;
  };

  /// C on a lattice of 12³ particles with its low corner at the origin.
  Found measured(const std::vector<ShapeDef>& shapes) {
    World world(world_def(GetParam(), s));
    for (const ShapeDef& def : shapes) world.create_shape(def);
    const FluidId water = world.create_fluid({});
    world.add_particles(water, lattice(12, 12, 12, s, {0, 0, 0}));
    return {{world.positions().begin(), world.positions().end()},
            {world.density_errors().begin(), world.density_errors().end()}};
  }

  static ShapeDef wall(Vec3 normal) { return shape(PlaneGeometry{normal, 0}); }

  /// Whether x is farther than h from the lattice's open ends.
  static bool is_inner(float x) { return x < 0.5f - 0.001f; }
};

TEST_P(MirrorGhostsTest, AHalfLatticeAtAWallIsAtItsRestDensity) {
  const Found f = measured({wall({1, 0, 0})});
  int seen = 0;
  for (size_t i = 0; i < f.positions.size(); ++i) {
    const Vec3 p = f.positions[i];
    if (!is_inner(p.x) || !is_inner(p.y) || !is_inner(p.z) || p.y < 0.1f || p.z < 0.1f) continue;
    EXPECT_NEAR(f.errors[i], 0, 5e-6) << p.x << " " << p.y << " " << p.z;
    ++seen;
  }
  EXPECT_GT(seen, 500);
}

TEST_P(MirrorGhostsTest, SoItIsInAnEdgeAndInACorner) {
  const Found f = measured({wall({1, 0, 0}), wall({0, 1, 0}), wall({0, 0, 1})});
  for (size_t i = 0; i < f.positions.size(); ++i) {
    const Vec3 p = f.positions[i];
    if (is_inner(p.x) && is_inner(p.y) && is_inner(p.z)) {
      EXPECT_NEAR(f.errors[i], 0, 5e-6) << p.x << " " << p.y << " " << p.z;
    }
  }
}

TEST_P(MirrorGhostsTest, AContainerFilledToItsWallsIsAtItsRestDensity) {
  const Found f = measured({tank({0, 0, 0}, {0.6f, 0.6f, 0.6f})});
  for (size_t i = 0; i < f.positions.size(); ++i) EXPECT_NEAR(f.errors[i], 0, 5e-6);
}

TEST_P(MirrorGhostsTest, ATurnedContainerToo) {
  ShapeDef container = tank({-0.3f, -0.3f, -0.3f}, {0.3f, 0.3f, 0.3f});
  container.pose.position = {0.7f, -0.4f, 0.2f};
  container.pose.rotation = about_z(31);
  World world(world_def(GetParam(), s));
  world.create_shape(container);
  FluidVolumeDef fill = block(world.create_fluid({}), {-0.3f, -0.3f, -0.3f}, {0.3f, 0.3f, 0.3f});
  fill.pose = container.pose;
  EXPECT_EQ(world.add_fluid(fill), 1728u);
  for (float error : world.density_errors()) EXPECT_NEAR(error, 0, 2e-5);
}

TEST_P(MirrorGhostsTest, TwoSolidsThatMakeUpOneFloorCountOnce) {
  const Found one = measured({wall({0, 1, 0})});
  const Found two = measured({shape(BoxGeometry{{1, 0.5f, 1}}, {-0.7f, -0.5f, 0}),
                              shape(BoxGeometry{{1, 0.5f, 1}}, {1.3f, -0.5f, 0})});
  for (size_t i = 0; i < one.positions.size(); ++i) {
    const Vec3 p = one.positions[i];
    if (std::fabs(p.x - 0.3f) > 0.11f) continue;  // around the seam
    EXPECT_NEAR(two.errors[i], one.errors[i], 0.02) << p.x << " " << p.y;
  }
}

TEST_P(MirrorGhostsTest, WithoutWallsTheSurfaceLacksDensity) {
  const Found f = measured({});
  for (size_t i = 0; i < f.positions.size(); ++i) {
    if (f.positions[i].x < s) {
      EXPECT_LT(f.errors[i], -0.1f);
    }
  }
}

MENISCUS_ON_EACH_DEVICE(MirrorGhostsTest);

}  // namespace
}  // namespace meniscus::tests
