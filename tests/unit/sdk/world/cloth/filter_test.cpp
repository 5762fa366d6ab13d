// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Which solids, and which other cloth, a piece of cloth collides with.
#include <gtest/gtest.h>

#include "tests/cloth_worlds.h"
#include "tests/unit/sdk/world/solids/body_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float dt = 1 / 60.0f;

class ClothFilterTest : public OnDevice {
 protected:
  World world_{world_def(GetParam(), 0.05f)};

  float lowest(ClothId id) const {
    float low = infinity;
    for (Vec3 x : world_.cloth_positions(id)) low = std::min(low, x.y);
    return low;
  }
  ClothId fall(Vec3 from, CollisionFilter filter) {
    ClothDef def = sheet(0.4f, 0.4f, 7, 7, from);
    def.filter = filter;
    def.fabric.drag = def.fabric.lift = 0;
    return world_.create_cloth(def);
  }
};

TEST_P(ClothFilterTest, SolidsStopWhatTheirMaskNames) {
  ShapeDef floor = shape(PlaneGeometry{});
  floor.filter = {1, 2};
  world_.create_shape(floor);
  const ClothId stops = fall({0, 0.1f, 0}, {2, 1}), not_named = fall({1, 0.1f, 0}, {4, 1}),
                names_not = fall({2, 0.1f, 0}, {2, 8});
  run(world_, 30, dt);
  EXPECT_GT(lowest(stops), 0);
  EXPECT_LT(lowest(not_named), -0.5f);
  EXPECT_LT(lowest(names_not), -0.5f);
}

TEST_P(ClothFilterTest, BodiesLikewise) {
  BodyDef table = kinematic(BoxGeometry{{2, 0.1f, 1}}, {0.5f, -0.1f, 0});
  table.filter = {1, 2};
  world_.create_body(table);
  const ClothId stops = fall({0, 0.1f, 0}, {2, 1}), passes = fall({1, 0.1f, 0}, {4, 1});
  run(world_, 30, dt);
  EXPECT_GT(lowest(stops), 0);
  EXPECT_LT(lowest(passes), -0.5f);
}

TEST_P(ClothFilterTest, ClothStopsOtherClothThatItNames) {
  const auto upper_after = [&](CollisionFilter lower, CollisionFilter upper) {
    World world(world_def(GetParam(), 0.05f));
    ClothDef held = sheet(0.6f, 0.6f, 13, 13);
    held.filter = lower;
    const ClothId table = world.create_cloth(held);
    std::vector<uint32_t> border;
    for (uint32_t v = 0; v < 169; ++v) {
      if (v % 13 == 0 || v % 13 == 12 || v < 13 || v >= 156) border.push_back(v);
    }
    world.create_attachment(attach(table, border));
    ClothDef def = sheet(0.2f, 0.2f, 5, 5, {0, 0.06f, 0});
    def.filter = upper;
    const ClothId id = world.create_cloth(def);
    run(world, 30, dt);
    return world.cloth_state(id).centre.y;
  };
  EXPECT_GT(upper_after({1, 1}, {1, 1}), -0.05f);
  EXPECT_LT(upper_after({1, 1}, {2, 1}), -0.5f);
  EXPECT_LT(upper_after({1, 2}, {1, 1}), -0.5f);
  EXPECT_GT(upper_after({1, 2}, {2, 1}), -0.05f);
}

TEST_P(ClothFilterTest, RopesStopAtSolidsThatTheyName) {
  ShapeDef floor = shape(PlaneGeometry{});
  floor.filter = {1, 2};
  world_.create_shape(floor);
  RopeDef def = rope({{0, 0.1f, 0}, {0.5f, 0.1f, 0}}, 8);
  def.radius = 0.02f;
  def.filter = {2, 1};
  const RopeId stops = world_.create_rope(def);
  def.filter = {4, 1};
  def.pose.position = {0, 0, 1};
  const RopeId passes = world_.create_rope(def);
  run(world_, 40, dt);
  for (Vec3 x : world_.rope_positions(stops)) EXPECT_NEAR(x.y, 0.02f, 2e-3f);
  EXPECT_LT(world_.rope_positions(passes)[4].y, -0.5f);
}

// Else the solid that holds it would push it off.
TEST_P(ClothFilterTest, ClothTouchesNotTheBodyThatItIsAttachedTo) {
  const ClothId id = fall({0, 0, 0}, {});
  const BodyId ball = world_.create_body(kinematic(SphereGeometry{0.03f}));
  AttachmentDef def = attach(id, {24});
  def.body = ball;
  const AttachmentId held = world_.create_attachment(def);
  run(world_, 60, dt);
  expect_near(world_.cloth_positions(id)[24], {0, 0, 0}, 2e-3f);
  EXPECT_NEAR(world_.attachment_force(held).y, -world_.cloth_state(id).mass * 9.81f, 0.6f);
}

MENISCUS_ON_EACH_DEVICE(ClothFilterTest);

}  // namespace
}  // namespace meniscus::tests
