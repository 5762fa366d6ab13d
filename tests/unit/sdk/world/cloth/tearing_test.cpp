// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cloth that is stretched too far tears, and all read-outs reflect it.
#include <gtest/gtest.h>

#include <set>

#include "tests/cloth_worlds.h"
#include "tests/unit/sdk/world/solids/body_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float dt = 1 / 60.0f;

class ClothTearTest : public OnDevice {
 protected:
  struct Rack {
    World world;
    ClothId cloth;
    BodyId jaw;
  };

  /// A sheet of 1 m by 0.5 m, held by its left edge, and by a jaw at its right that moves off at 1 m/s.
  static Rack make(pbd::DeviceKind device, float tear_strain) {
    Rack r{World(weightless(device)), {}, {}};
    ClothDef def = sheet(1, 0.5f, 13, 7);
    def.fabric.tear_strain = tear_strain;
    def.tethers = false;
    r.cloth = r.world.create_cloth(def);
    r.jaw = r.world.create_body(kinematic(BoxGeometry{{0.01f, 0.01f, 0.3f}}, {0.53f, 0, 0}));
    std::vector<uint32_t> left, right;
    for (uint32_t row = 0; row < 7; ++row) {
      left.push_back(13 * row);
      right.push_back(13 * row + 12);
    }
    r.world.create_attachment(attach(r.cloth, left));
    AttachmentDef grip = attach(r.cloth, right);
    grip.body = r.jaw;
    r.world.create_attachment(grip);
    r.world.move_body(r.jaw, {{1.53f, 0, 0}, {0, 0, 0, 1}}, 1);
    return r;
  }

  static void expect_sizes(const World& world, ClothId id, size_t vertices) {
    EXPECT_EQ(world.cloth_positions(id).size(), vertices);
    EXPECT_EQ(world.cloth_velocities(id).size(), vertices);
    EXPECT_EQ(world.cloth_normals(id).size(), vertices);
    EXPECT_EQ(world.cloth_strains(id).size(), 144u);
    EXPECT_EQ(world.cloth_triangles(id).size(), 432u);
  }
};

TEST_P(ClothTearTest, WhatIsPulledTooFarTearsAndReadOutsAgree) {
  Rack r = make(GetParam(), 0.1f);
  const float mass = r.world.cloth_state(r.cloth).mass, area = r.world.cloth_state(r.cloth).area;
  size_t vertices = 91;
  for (int k = 0; k < 90; ++k) {
    r.world.step(dt);
    for (const TearEvent& tear : r.world.tear_events()) {
      EXPECT_EQ(tear.cloth, r.cloth);
      EXPECT_EQ(tear.copy, vertices++);
      EXPECT_LT(tear.original, tear.copy);
      EXPECT_EQ(r.world.cloth_positions(r.cloth)[tear.copy], r.world.cloth_positions(r.cloth)[tear.original]);
    }
    expect_sizes(r.world, r.cloth, vertices);
  }
  EXPECT_GT(vertices, 95u);
  EXPECT_TRUE(r.world.tear_events().empty()) << "it tears for ever";
  const ClothState state = r.world.cloth_state(r.cloth);
  EXPECT_NEAR(state.mass, mass, 1e-5f * mass);
  EXPECT_NEAR(state.area, area, 1e-5f * area);
  EXPECT_LT(state.max_stretch, 1.15f);
  EXPECT_EQ(r.world.diagnostics().non_finite, 0u);
}

TEST_P(ClothTearTest, TheTornHalvesPart) {
  Rack r = make(GetParam(), 0.05f);
  run(r.world, 90, dt);
  // No path along edges remains from the left edge to the right one.
  const auto triangles = r.world.cloth_triangles(r.cloth);
  std::set<uint32_t> reached{0};
  for (bool grew = true; grew;) {
    grew = false;
    for (size_t t = 0; t < triangles.size(); t += 3) {
      const uint32_t* corner = &triangles[t];
      if (!reached.count(corner[0]) && !reached.count(corner[1]) && !reached.count(corner[2])) continue;
      for (int k = 0; k < 3; ++k) grew |= reached.insert(corner[k]).second;
    }
  }
  for (uint32_t row = 0; row < 7; ++row) EXPECT_FALSE(reached.count(13 * row + 12)) << "row " << row;
}

TEST_P(ClothTearTest, WithoutALimitNothingTears) {
  Rack r = make(GetParam(), 0);
  for (int k = 0; k < 30; ++k) {
    r.world.step(dt);
    EXPECT_TRUE(r.world.tear_events().empty());
  }
  expect_sizes(r.world, r.cloth, 91);
  EXPECT_GT(r.world.cloth_state(r.cloth).max_stretch, 1.3f);
}

TEST_P(ClothTearTest, EventsAreOfTheLastStepAndGoWithTheCloth) {
  Rack r = make(GetParam(), 0.05f);
  for (int k = 0; k < 90 && r.world.tear_events().empty(); ++k) r.world.step(dt);
  ASSERT_FALSE(r.world.tear_events().empty());
  const size_t vertices = r.world.cloth_positions(r.cloth).size();
  r.world.destroy_cloth(r.cloth);
  EXPECT_TRUE(r.world.tear_events().empty());
  EXPECT_GT(vertices, 91u);
}

// A failed step has not happened.
TEST_P(ClothTearTest, AFailedStepLeavesTheEventsOfTheOneBefore) {
  Rack r = make(GetParam(), 0.05f);
  for (int k = 0; k < 90 && r.world.tear_events().empty(); ++k) r.world.step(dt);
  const size_t tears = r.world.tear_events().size();
  ASSERT_GT(tears, 0u);
  expect_error(ErrorCode::non_finite, "non-finite", [&] {
    const std::vector<Vec3> position{{9, 9, 9}}, velocity{{3e38f, 0, 0}};
    r.world.add_particles(r.world.create_fluid({}), position, velocity);
    r.world.step(1000);
  });
  EXPECT_EQ(r.world.tear_events().size(), tears);
}

TEST_P(ClothTearTest, TheSameTearsEveryTime) {
  Rack a = make(GetParam(), 0.05f), b = make(GetParam(), 0.05f);
  for (int k = 0; k < 40; ++k) {
    a.world.step(dt);
    b.world.step(dt);
    a.world.cloth_normals(a.cloth);
  }
  EXPECT_EQ(a.world.state_hash(), b.world.state_hash());
}

MENISCUS_ON_EACH_DEVICE(ClothTearTest);

}  // namespace
}  // namespace meniscus::tests
