// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cloth where several things that hold it, or that it touches, meet.
#include <gtest/gtest.h>

#include "tests/cloth_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float dt = 1 / 60.0f;

class ClothMeetings : public OnDevice {
 protected:
  static constexpr uint32_t rows = 16;
  static constexpr float width = 0.3f, away = 0.5f;  // m

  World world_with(Vec3 gravity) {
    WorldDef def = world_def(GetParam(), 0.05f);
    def.substeps = 4;
    def.iterations = 1;
    def.gravity = gravity;
    return World(def);
  }

  static std::vector<uint32_t> column(uint32_t number) {
    std::vector<uint32_t> vertices;
    for (uint32_t row = 0; row < rows; ++row) vertices.push_back(rows * row + number);
    return vertices;
  }

  static ClothDef small_sheet(float height) {
    ClothDef def = sheet(width, width, rows, rows, {0, height, 0});
    def.fabric.thickness = 0.006f;
    def.filter = {1, 1};
    return def;
  }

  static BodyDef holder() {
    BodyDef def;
    def.geometry = BoxGeometry{{0.02f, 0.3f, 0.3f}};
    def.motion = BodyMotion::kinematic;
    def.pose.position = {-away, 0, 0};
    def.filter = {2, 2};
    return def;
  }

  static AttachmentDef attachment(ClothId cloth, BodyId body) {
    AttachmentDef def = attach(cloth, column(0));
    def.body = body;
    return def;
  }
};
MENISCUS_ON_EACH_DEVICE(ClothMeetings);

/// On its corner.
ShapeDef upturned_box() {
  ShapeDef def = shape(BoxGeometry{{0.15f, 0.15f, 0.15f}});
  def.pose.rotation = {0.325058f, 0, -0.325058f, 0.888074f};
  return def;
}

TEST_P(ClothMeetings, ABodyTakesItsAttachmentsThroughClothThatIsHeldFast) {
  World world = world_with({0, 0, 0});
  const BodyId body = world.create_body(holder());
  const ClothId attached = world.create_cloth(small_sheet(0)), held = world.create_cloth(small_sheet(0.012f));
  world.create_attachment(attach(held, column(0)));
  world.create_attachment(attach(held, column(rows - 1)));
  world.create_attachment(attachment(attached, body));
  world.step(dt);
  const auto start = copy_of(world.cloth_positions(attached));
  world.move_body(body, {{-away, 0.15f, 0}, {0, 0, 0, 1}}, 0.15f);
  for (int k = 0; k < 14; ++k) {
    world.step(dt);
    const float height = world.body_state(body).pose.position.y;
    for (uint32_t v : column(0))
      ASSERT_LT(length(world.cloth_positions(attached)[v] - start[v] - Vec3{0, height, 0}), 1e-5f) << k;
  }
}

TEST_P(ClothMeetings, ManyRoundsOfTheGuardDoNotStopARelaxation) {
  World world = world_with({0, -9.81f, 0});
  const BodyId body = world.create_body(holder());
  const ClothId attached = world.create_cloth(small_sheet(0)),
                above = world.create_cloth(small_sheet(0.012f));
  world.create_cloth(small_sheet(-0.012f));
  world.create_attachment(attachment(attached, body));
  world.create_attachment(attach(above, column(rows - 1)));
  world.step(dt);
  world.set_body_pose(body, {{-away + 0.02f, 0.05f, 0}, {0, 0, 0, 1}});
  for (int k = 0; k < 4; ++k) world.relax(1);
}

TEST_P(ClothMeetings, ClothMayComeAnewWhereFacesHaveTouched) {
  World world = world_with({0, -9.81f, 0});
  world.create_shape(upturned_box());
  ClothId id{};
  for (int turn = 0; turn < 2; ++turn) {
    id = world.create_cloth(sheet(0.8f, 0.8f, 10, 10, {0, 0.28f, 0}));
    for (int k = 0; k < 20; ++k) world.step(dt);
    for (Vec3 x : world.cloth_positions(id)) ASSERT_TRUE(std::isfinite(x.y));
    if (turn > 0) continue;
    world.destroy_cloth(id);
    world.step(dt);
  }
}

TEST_P(ClothMeetings, AGranularMaterialLeavesTheMomentumOfFacesAndBodies) {
  World world = world_with({0, 0, 0});
  world.create_granular({});
  BodyDef def;
  def.geometry = BoxGeometry{{0.1f, 0.1f, 0.1f}};
  def.density = 100;
  def.pose.rotation = upturned_box().pose.rotation;
  def.can_sleep = false;
  const BodyId body = world.create_body(def);
  ClothDef cloth = sheet(0.6f, 0.6f, 8, 8, {0, 0.25f, 0});
  cloth.velocity = {0, -1, 0};
  cloth.fabric.drag = cloth.fabric.lift = 0;
  cloth.self_collision = false;
  cloth.fabric.thickness = 0.02f;
  const ClothId id = world.create_cloth(cloth);
  const auto momentum = [&] {
    return world.cloth_state(id).momentum + world.body_mass(body).mass * world.body_state(body).velocity;
  };
  const Vec3 before = momentum();
  for (int k = 0; k < 20; ++k) world.step(dt);
  EXPECT_GT(length(world.body_state(body).velocity), 0.02f);
  EXPECT_LT(length(momentum() - before), 1e-4f * length(before));
}

TEST_P(ClothMeetings, WhatIsPutElsewhereLeavesClothAtRest) {
  float height[2];
  for (int turn = 0; turn < 2; ++turn) {
    World world = world_with({0, -9.81f, 0});
    world.create_shape(upturned_box());
    ClothDef def = sheet(0.8f, 0.8f, 10, 10, {0, 0.29f, 0});
    def.fabric.density = 20;
    def.fabric.thickness = 0.02f;
    const ClothId id = world.create_cloth(def);
    world.create_attachment(attach(id, {0, 9, 90, 99}));
    for (int k = 0; k < 90; ++k) {
      if (k == 60 && turn == 1) world.create_shape(shape(SphereGeometry{0.1f}, {30, 30, 30}));
      world.step(dt);
    }
    height[turn] = -1;
    for (Vec3 x : world.cloth_positions(id)) height[turn] = std::max(height[turn], x.y);
  }
  EXPECT_NEAR(height[1], height[0], 1e-4f);
}

}  // namespace
}  // namespace meniscus::tests
