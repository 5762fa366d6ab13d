// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Attachments of cloth and ropes, and the forces in them. Those of bodies are in attached_bodies_test.cpp.
#include <gtest/gtest.h>

#include "tests/unit/sdk/world/cloth/hanging.h"

namespace meniscus::tests {
namespace {

constexpr float g = 9.81f;

class ClothAttachmentTest : public OnDevice, protected Hanging {
 protected:
  ClothAttachmentTest() : Hanging(world_def(GetParam(), 0.05f)) {}
};

TEST_P(ClothAttachmentTest, WhatTheWorldHoldsStaysWhereItIs) {
  const ClothId id = world_.create_cloth(sheet(1, 1, 5, 5, {0, 2, 0}));
  AttachmentDef def = attach(id, {7});
  def.region = Aabb{{-1, 1, -0.51f}, {1, 3, -0.49f}};
  const AttachmentId held = world_.create_attachment(def);
  EXPECT_EQ(world_.attachment_vertices(held), (std::vector<uint32_t>{0, 1, 2, 3, 4, 7}));
  EXPECT_EQ(world_.attachment_force(held), (Vec3{0, 0, 0}));
  const std::vector<Vec3> before = copy_of(world_.cloth_positions(id));
  run(world_, 40, 0.016f);
  for (uint32_t v : world_.attachment_vertices(held)) {
    EXPECT_EQ(world_.cloth_positions(id)[v], before[v]);
    EXPECT_EQ(world_.cloth_velocities(id)[v], (Vec3{0, 0, 0}));
  }
  EXPECT_LT(world_.cloth_positions(id)[24].y, 1.5f);
  world_.destroy_attachment(held);
  run(world_, 20, 0.016f);
  EXPECT_LT(world_.cloth_positions(id)[0].y, 1.8f);
}

TEST_P(ClothAttachmentTest, TheWorldBearsTheWeightOfWhatHangs) {
  const ClothId id = hanging_sheet();
  const AttachmentId held = world_.create_attachment(attach(id, vertices_from(0, 9)));
  settle(2);
  const float weight = world_.cloth_state(id).mass * g;
  expect_near(mean_force(held), {0, -weight, 0}, 0.01f * weight);
}

TEST_P(ClothAttachmentTest, TwoAttachmentsShareTheWeight) {
  const ClothId id = hanging_sheet();
  const AttachmentId left = world_.create_attachment(attach(id, {0})),
                     right = world_.create_attachment(attach(id, {8}));
  settle(3);
  const float weight = world_.cloth_state(id).mass * g;
  const Vec3 a = mean_force(left), b = mean_force(right);
  EXPECT_NEAR(a.y + b.y, -weight, 0.02f * weight);
  EXPECT_NEAR(a.y, b.y, 0.1f * weight);
  EXPECT_GT(a.x, 0);
  EXPECT_LT(b.x, 0);
}

// ---- seams ----

TEST_P(ClothAttachmentTest, ASeamHoldsTwoSheetsTogether) {
  ClothDef left = sheet(0.5f, 0.5f, 9, 9, {-0.255f, 0, 0}), right = left;
  right.pose.position.x = 0.255f;
  left.fabric.thickness = right.fabric.thickness = 0.005f;  // what is thicker than a seam is long parts it
  const ClothId a = world_.create_cloth(left), b = world_.create_cloth(right);
  std::vector<uint32_t> hem, rail;
  for (uint32_t row = 0; row < 9; ++row) {
    hem.push_back(9 * row + 8);
    rail.push_back(9 * row);
  }
  world_.create_attachment(attach(a, rail));
  AttachmentDef def = attach(a, hem);
  def.other_cloth = b;
  const AttachmentId seam = world_.create_attachment(def);
  settle(2);
  const auto x = world_.cloth_positions(a), y = world_.cloth_positions(b);
  for (uint32_t row = 0; row < 9; ++row)
    EXPECT_NEAR(length(x[9 * row + 8] - y[9 * row]), 0.01f, 1e-3f) << "row " << row;
  EXPECT_NEAR(world_.cloth_state(b).centre.y, -0.76f, 0.04f);
  EXPECT_EQ(world_.attachment_force(seam), (Vec3{0, 0, 0}));
  world_.destroy_attachment(seam);
  run(world_, 30, 1 / 60.0f);
  EXPECT_LT(world_.cloth_state(b).centre.y, -1.5f);
}

TEST_P(ClothAttachmentTest, ASeamOfSomeComplianceGivesWayByIt) {
  const ClothId a = world_.create_cloth(sheet(0.2f, 0.2f, 2, 2)),
                b = world_.create_cloth(sheet(0.2f, 0.2f, 2, 2, {0, -0.05f, 0}));
  world_.create_attachment(attach(a, vertices_from(0, 4)));
  AttachmentDef def = attach(a, vertices_from(0, 4));
  def.other_cloth = b;
  def.reach = 0.06f;
  def.compliance = 0.5f;
  world_.create_attachment(def);
  settle(3);
  // Four seams carry the lower sheet.
  const float weight = world_.cloth_state(b).mass * g;
  EXPECT_NEAR(world_.cloth_state(b).centre.y, -0.05f - 0.25f * 0.5f * weight, 2e-3f);
}

TEST_P(ClothAttachmentTest, ASheetHangsFromARopeAndARopeFromASheet) {
  const ClothId id = hanging_sheet(1);
  RopeDef line = rope({{-0.25f, 1.02f, 0}, {0.25f, 1.02f, 0}}, 8), tail = rope({{0, 0.48f, 0}, {0, 0, 0}}, 4);
  const RopeId above = world_.create_rope(line), below = world_.create_rope(tail);
  world_.create_attachment(attach(above, vertices_from(0, 9)));
  AttachmentDef to_rope = attach(id, vertices_from(0, 9)), to_cloth = attach(below, {0});
  to_rope.other_rope = above;
  to_cloth.other_cloth = id;
  world_.create_attachment(to_rope);
  world_.create_attachment(to_cloth);
  settle(2);
  EXPECT_NEAR(world_.cloth_state(id).centre.y, 0.75f, 0.01f);
  EXPECT_NEAR(world_.rope_positions(below)[4].y, 0, 0.03f);
}

TEST_P(ClothAttachmentTest, AClampedRodKeepsItsDirection) {
  RopeDef rod = rope({{0, 0, 0}, {0.5f, 0, 0}}, 10);
  rod.bends_and_twists = true;
  rod.youngs_modulus = 1e9f;
  const RopeId clamped = world_.create_rope(rod);
  rod.pose.position = {0, 0, 1};
  const RopeId hinged = world_.create_rope(rod);
  AttachmentDef def = attach(clamped, {0, 1});
  def.clamped = true;
  world_.create_attachment(def);
  world_.create_attachment(attach(hinged, {0}));
  run(world_, 30, 1 / 60.0f);
  EXPECT_GT(world_.rope_positions(clamped)[10].y, -0.1f);
  EXPECT_LT(world_.rope_positions(hinged)[10].y, -0.2f);
}

// ---- tethers ----

/// m, of a metre of cloth that has hung for a second and a half.
float hanging_length(const WorldDef& settings, StretchModel model, float stiffness, bool tethers) {
  World world(settings);
  ClothDef def = sheet(1, 1, 25, 25);
  def.fabric.stretch_model = model;
  def.fabric.warp_stiffness = def.fabric.weft_stiffness = stiffness;
  def.tethers = tethers;
  const ClothId id = world.create_cloth(def);
  world.create_attachment(attach(id, vertices_from(0, 25)));
  run(world, 90, 1 / 60.0f);
  const auto x = world.cloth_positions(id);
  return length(x[24 * 25 + 12] - x[12]);
}

TEST_P(ClothAttachmentTest, TethersBoundTheStretch) {
  WorldDef few = world_def(GetParam(), 0.05f);
  few.substeps = few.iterations = 1;
  EXPECT_LT(hanging_length(few, StretchModel::triangles, 20000, true), 1.005f);
  EXPECT_GT(hanging_length(few, StretchModel::triangles, 20000, false), 1.05f);
}

// Beside fabric that already carries its weight they add as much stiffness again.
TEST_P(ClothAttachmentTest, TethersAreAsStiffAsTheFabric) {
  WorldDef many = world_def(GetParam(), 0.05f);
  many.substeps = 10;
  const float without = hanging_length(many, StretchModel::edges, 20, false);
  EXPECT_GT(without, 1.03f);
  EXPECT_NEAR((hanging_length(many, StretchModel::edges, 20, true) - 1) / (without - 1), 0.5f, 0.1f);
}

MENISCUS_ON_EACH_DEVICE(ClothAttachmentTest);

}  // namespace
}  // namespace meniscus::tests
