// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The read-outs of cloth and ropes: they exist from the start, and do not depend on when they are read.
#include <gtest/gtest.h>

#include "tests/cloth_worlds.h"
#include "tests/unit/sdk/world/solids/body_worlds.h"

namespace meniscus::tests {
namespace {

class ClothReadoutTest : public OnDevice {
 protected:
  World world_{weightless(GetParam())};

  void expect_sizes(ClothId id, size_t vertices, size_t triangles) const {
    EXPECT_EQ(world_.cloth_positions(id).size(), vertices);
    EXPECT_EQ(world_.cloth_velocities(id).size(), vertices);
    EXPECT_EQ(world_.cloth_normals(id).size(), vertices);
    EXPECT_EQ(world_.cloth_triangles(id).size(), 3 * triangles);
    EXPECT_EQ(world_.cloth_strains(id).size(), triangles);
    for (uint32_t v : world_.cloth_triangles(id)) EXPECT_LT(v, vertices);
    for (Vec3 n : world_.cloth_normals(id)) EXPECT_NEAR(length(n), 1, 1e-5f);
  }
};

TEST_P(ClothReadoutTest, ASheetIsThereBeforeAnyStep) {
  ClothDef def = sheet(3, 2, 4, 3, {1, 2, 3});
  def.velocity = {4, 5, 6};
  const ClothId id = world_.create_cloth(def);
  expect_sizes(id, 12, 12);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      const auto v = static_cast<size_t>(4 * row + column);
      expect_near(world_.cloth_positions(id)[v], {float(column) - 0.5f, 2, float(row) + 2}, 1e-6f);
      EXPECT_EQ(world_.cloth_velocities(id)[v], (Vec3{4, 5, 6}));
      expect_near(world_.cloth_normals(id)[v], world_.cloth_normals(id)[0], 1e-6f);
    }
  }
  EXPECT_NEAR(std::fabs(world_.cloth_normals(id)[0].y), 1, 1e-6f);
  const ClothState state = world_.cloth_state(id);
  EXPECT_NEAR(state.area, 6, 1e-5f);
  EXPECT_NEAR(state.mass, 6 * def.fabric.density, 1e-5f);
  EXPECT_NEAR(state.mean_stretch, 0, 1e-6f);
  EXPECT_NEAR(state.max_stretch, 1, 1e-6f);
  expect_near(state.centre, {1, 2, 3}, 1e-5f);
  expect_near(state.momentum, state.mass * Vec3{4, 5, 6}, 1e-4f);
  EXPECT_NEAR(state.kinetic_energy, 0.5f * state.mass * 77, 1e-3f);
  EXPECT_NEAR(world_.diagnostics().kinetic_energy, 0.5f * state.mass * 77, 1e-3f);
  EXPECT_FALSE(state.closed);
  EXPECT_EQ(state.volume, 0);
}

TEST_P(ClothReadoutTest, AStepMovesAllOfIt) {
  ClothDef def = sheet(1, 1, 5, 5);
  def.velocity = {1, 0, 0};
  def.fabric.drag = def.fabric.lift = 0;
  const ClothId id = world_.create_cloth(def);
  world_.cloth_normals(id);
  run(world_, 10, 0.01f);
  expect_sizes(id, 25, 32);
  expect_near(world_.cloth_state(id).centre, {0.1f, 0, 0}, 1e-5f);
  expect_near(world_.cloth_positions(id)[24], {0.6f, 0, 0.5f}, 1e-5f);
  EXPECT_NEAR(world_.time(), 0.1, 1e-6);
}

TEST_P(ClothReadoutTest, WhatIsMadeLaterTakesNothingFromTheFirst) {
  ClothDef def = sheet(1, 1, 4, 4);
  def.velocity = {0, 1, 0};
  def.fabric.drag = def.fabric.lift = 0;
  const ClothId first = world_.create_cloth(def);
  run(world_, 10, 0.01f);
  const ClothId second = world_.create_cloth(sheet(1, 1, 3, 3, {4, 0, 0}));
  expect_near(world_.cloth_state(first).centre, {0, 0.1f, 0}, 1e-5f);
  expect_near(world_.cloth_state(second).centre, {4, 0, 0}, 1e-5f);
  run(world_, 10, 0.01f);
  expect_near(world_.cloth_state(first).centre, {0, 0.2f, 0}, 1e-5f);
  world_.destroy_cloth(first);
  expect_near(world_.cloth_state(second).centre, {4, 0, 0}, 1e-5f);
  expect_sizes(second, 9, 8);
}

TEST_P(ClothReadoutTest, StretchIsSeenAsStrain) {
  ClothDef def = sheet(1, 1, 5, 5);
  def.stretch = {1.1f, 1, 0.9f};
  const ClothId id = world_.create_cloth(def);
  for (float strain : world_.cloth_strains(id)) EXPECT_NEAR(strain, 0.1f, 1e-5f);
  const ClothState state = world_.cloth_state(id);
  EXPECT_NEAR(state.max_stretch, 1.1f, 1e-5f);
  EXPECT_GT(state.mean_stretch, 0.05f);
  EXPECT_NEAR(state.area, 1, 1e-5f);
}

TEST_P(ClothReadoutTest, SpheresAndTubesAreWhatTheySay) {
  ClothDef ball, skirt;
  ball.geometry = ClothSphere{0.5f, 12};
  skirt.geometry = ClothTube{0.2f, 0.5f, 0.6f, 64, 25};
  skirt.pose.position = {3, 0, 0};
  const ClothId round = world_.create_cloth(ball), open = world_.create_cloth(skirt);
  expect_sizes(round, 10 * 144 + 2, 20 * 144);
  expect_sizes(open, 64 * 25, 2 * 64 * 24);
  const ClothState sphere = world_.cloth_state(round), tube = world_.cloth_state(open);
  EXPECT_TRUE(sphere.closed);
  EXPECT_NEAR(sphere.volume, 4 * pi / 3 * 0.125f, 0.02f * sphere.volume);
  EXPECT_NEAR(sphere.area, pi, 0.01f * pi);
  EXPECT_FALSE(tube.closed);
  EXPECT_NEAR(tube.area, pi * 0.7f * std::sqrt(0.36f + 0.09f), 0.01f);
}

// By area of the triangles they would, by 2.5 degrees here, and to the other side in the next row.
TEST_P(ClothReadoutTest, NormalsDoNotLeanToTheSideOfDiagonals) {
  constexpr int around = 24, rows = 9;
  ClothDef ball, pipe;
  ball.geometry = ClothSphere{0.5f, 6};
  pipe.geometry = ClothTube{0.5f, 0.5f, 1, around, rows};
  pipe.pose.position = {3, 0, 0};
  const ClothId round = world_.create_cloth(ball), tube = world_.create_cloth(pipe);
  const std::span<const Vec3> at = world_.cloth_positions(round), normals = world_.cloth_normals(round);
  for (size_t v = 0; v < at.size(); ++v) expect_near(0.5f * normals[v], at[v], 1e-5f);
  const std::span<const Vec3> x = world_.cloth_positions(tube), n = world_.cloth_normals(tube);
  for (size_t v = around; v < (rows - 1) * around; ++v)
    expect_near(0.5f * n[v], {x[v].x - 3, 0, x[v].z}, 1e-5f);
}

TEST_P(ClothReadoutTest, ATubeWithABottomIsABag) {
  ClothDef def;
  def.geometry = ClothTube{0.2f, 0.2f, 0.3f, 40, 11, true};
  const ClothId bag = world_.create_cloth(def);
  const ClothState state = world_.cloth_state(bag);
  EXPECT_FALSE(state.closed);
  EXPECT_NEAR(state.area, pi * (0.04f + 0.4f * 0.3f), 0.01f * state.area);
  // One piece with one border, of the upper end's edges: V − E + F = 1, and 3 F = 2 E − 40.
  const std::span<const Vec3> x = world_.cloth_positions(bag), n = world_.cloth_normals(bag);
  const size_t faces = world_.cloth_triangles(bag).size() / 3;
  EXPECT_EQ(2 * (x.size() - 1), faces + 40);
  for (size_t v = 440; v < x.size(); ++v) {
    EXPECT_FLOAT_EQ(x[v].y, -0.15f);
    EXPECT_NEAR(n[v].y, -1, 1e-6f) << "vertex " << v;
  }
  EXPECT_EQ(x.back().x, 0) << "the last one is the middle";
  for (const char* shape : {"three", "many"}) {
    def.geometry = ClothTube{1, 1, 1, std::string(shape) == "three" ? 3 : 97, 2, true};
    EXPECT_NO_THROW(world_.create_cloth(def)) << shape;
  }
}

TEST_P(ClothReadoutTest, AFileIsWelded) {
  const TemporaryFolder folder;
  ClothDef def;
  def.geometry = ClothFile{folder.write("brick.obj", brick_obj), 0.1f};
  const ClothId id = world_.create_cloth(def);
  expect_sizes(id, 8, 12);
  EXPECT_TRUE(world_.cloth_state(id).closed);
  EXPECT_NEAR(world_.cloth_state(id).volume, 0.006f, 1e-6f);
}

TEST_P(ClothReadoutTest, ASeamOfAFileIsWeldedAndCounted) {
  const TemporaryFolder folder;
  const char* seam =
      "v 0 0 0\nv 0.1 0 0\nv 0.100004 0 0\nv 0.2 0 0\nv 0 0 0.1\nv 0.1 0 0.1\nv 0.100004 0 0.1\nv 0.2 0 0.1\n"
      "f 1 5 6\nf 1 6 2\nf 2 6 7\nf 2 7 3\nf 3 7 8\nf 3 8 4\n";
  ClothDef def;
  ClothFile file{folder.write("seam.obj", seam), 1};
  def.geometry = file;
  const ClothId id = world_.create_cloth(def);
  expect_sizes(id, 6, 4);
  EXPECT_EQ(world_.cloth_welded_vertices(id), 2u);
  file.weld = 0;
  def.geometry = file;
  expect_error(ErrorCode::mesh, "of a cloth mesh is 4", [&] { world_.create_cloth(def); });
}

TEST_P(ClothReadoutTest, RopesHaveVerticesAndRodsFrames) {
  RopeDef line = rope({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, 8), rod = line;
  rod.bends_and_twists = true;
  rod.pose.position = {3, 0, 0};
  rod.velocity = {0, 0, 2};
  RopeDef hoop = rope({{0, 0, 3}, {1, 0, 3}, {0, 1, 3}}, 0);
  hoop.closed = true;
  const RopeId a = world_.create_rope(line), b = world_.create_rope(rod), c = world_.create_rope(hoop);
  for (int look = 0; look < 2; ++look) {
    ASSERT_EQ(world_.rope_positions(a).size(), 9u);
    EXPECT_EQ(world_.rope_velocities(b).size(), 9u);
    EXPECT_EQ(world_.rope_positions(c).size(), 3u);
    EXPECT_TRUE(world_.rope_frames(a).empty());
    ASSERT_EQ(world_.rope_frames(b).size(), 8u);
    EXPECT_TRUE(world_.rope_frames(c).empty());
    for (size_t s = 0; s < 8; ++s) {
      const Vec3 along = world_.rope_positions(b)[s + 1] - world_.rope_positions(b)[s];
      expect_near(rotate(world_.rope_frames(b)[s], {0, 0, 1}), normalized_or(along, {0, 0, 0}), 1e-3f);
    }
    expect_near(world_.rope_positions(a)[6], {1, 0.5f, 0}, 1e-3f);
    world_.step(0.01f);
  }
  EXPECT_NEAR(world_.rope_positions(b)[0].z, 0.04f, 1e-4f);
}

TEST_P(ClothReadoutTest, LookingLeavesNoTrace) {
  World alone(weightless(GetParam()));
  ClothDef def = sheet(1, 1, 9, 9);
  def.stretch = {1.05f, 1, 1};
  RopeDef rod = rope({{0, 2, 0}, {1, 2, 0}, {1, 3, 0}}, 8);
  rod.bends_and_twists = rod.straight_at_rest = true;
  const ClothId id = world_.create_cloth(def), twin = alone.create_cloth(def);
  const RopeId line = world_.create_rope(rod);
  alone.create_rope(rod);
  const AttachmentId held = world_.create_attachment(attach(id, {0}));
  alone.create_attachment(attach(twin, {0}));
  for (int k = 0; k < 20; ++k) {
    world_.step(0.01f);
    alone.step(0.01f);
    world_.cloth_normals(id);
    world_.cloth_strains(id);
    world_.cloth_state(id);
    world_.rope_frames(line);
    world_.attachment_force(held);
    world_.diagnostics();
  }
  EXPECT_EQ(world_.state_hash(), alone.state_hash());
}

TEST_P(ClothReadoutTest, TheHashSeesClothAndRopes) {
  const auto hash = [&](float x, float speed, float rope_x) {
    World world(weightless(GetParam()));
    ClothDef def = sheet(1, 1, 3, 3, {x, 0, 0});
    def.velocity = {0, speed, 0};
    world.create_cloth(def);
    world.create_rope(rope({{rope_x, 0, 0}, {5, 0, 0}}, 2));
    return world.state_hash();
  };
  const uint64_t first = hash(0, 0, 4);
  EXPECT_EQ(hash(0, 0, 4), first);
  EXPECT_NE(hash(1e-3f, 0, 4), first);
  EXPECT_NE(hash(0, 1e-3f, 4), first);
  EXPECT_NE(hash(0, 0, 4.001f), first);
}

TEST_P(ClothReadoutTest, ForcesOfTheLastStepOutliveChanges) {
  const auto force_after = [&](const auto& change) {
    World world(world_def(GetParam(), 0.1f));
    const ClothId id = world.create_cloth(sheet(1, 1, 9, 9));
    const AttachmentId held = world.create_attachment(attach(id, {0, 8}));
    run(world, 30, 1 / 60.0f);
    change(world);
    return world.attachment_force(held);
  };
  const Vec3 force = force_after([](World&) {});
  EXPECT_LT(force.y, -0.1f);
  EXPECT_EQ(force_after([](World& world) { world.relax(5); }), force);
  EXPECT_EQ(force_after([](World& world) {
              WorldDef def = world.def();
              def.gravity = {0, 100, 0};
              world.set_def(def);
            }),
            force);
}

// Those that lie along the axis that a crank turns about.
TEST_P(ClothReadoutTest, RelaxingTakesTheSpinFromRods) {
  RopeDef crank = rope({{0, 0, 0}, {0.5f, 0, 0}, {0.5f, 0.5f, 0}}, 10);
  crank.bends_and_twists = true;
  const RopeId id = world_.create_rope(crank);
  const uint32_t end[] = {10};
  const Vec3 impulse[] = {{0, 0, 0.1f}};
  world_.apply_impulses(id, end, impulse);
  run(world_, 10, 1 / 240.0f);
  const auto spin_in = [&](float dt) {
    const Quat before = world_.rope_frames(id)[2];
    world_.step(dt);
    return 2 * std::fabs((world_.rope_frames(id)[2] * conjugate(before)).x) / dt;
  };
  const float spin = spin_in(1e-4f);
  world_.relax(1);
  EXPECT_GT(spin, 10);
  EXPECT_LT(spin_in(1e-4f), 0.05f * spin);
}

// What is read of cloth must be what the device has, or the next upload brings back what was.
TEST_P(ClothReadoutTest, RelaxingLeavesNothingOutOfDate) {
  World unseen(weightless(GetParam()));
  ClothDef def = sheet(1, 1, 5, 5);
  def.velocity = {0, 1, 0};
  def.stretch = {1.05f, 1, 1};
  const ClothId id = world_.create_cloth(def);
  unseen.create_cloth(def);
  for (World* world : {&world_, &unseen}) world->step(0.01f);
  world_.cloth_positions(id);
  for (World* world : {&world_, &unseen}) {
    world->relax(5);
    world->create_rope(rope({{9, 0, 0}, {9, 1, 0}}, 2));
    world->step(0.01f);
  }
  EXPECT_EQ(world_.state_hash(), unseen.state_hash());
}

MENISCUS_ON_EACH_DEVICE(ClothReadoutTest);

}  // namespace
}  // namespace meniscus::tests
