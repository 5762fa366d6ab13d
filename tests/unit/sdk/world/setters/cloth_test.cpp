// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Positions and velocities of the vertices of cloth and ropes that are set from outside.
#include "tests/expect_error.h"
#include "tests/unit/sdk/world/snapshot/cases.h"

namespace meniscus::tests {
namespace {

constexpr int steps = 3;

class SetClothTest : public OnDevice {
 protected:
  World world_{world_def(GetParam(), 0.1f)};

  static std::vector<Vec3> shifted(std::span<const Vec3> points, Vec3 by) {
    std::vector<Vec3> to = copy_of(points);
    for (Vec3& p : to) p += by;
    return to;
  }
};

/// Cloth that was set and cloth that was made with the same positions and velocities have one future.
TEST_P(SetClothTest, PlacedClothIsLikeNewCloth) {
  World made(world_def(GetParam(), 0.1f));
  for (World* world : {&made, &world_}) world->create_shape(shape(SphereGeometry{0.2f}, {1, 0.7f, 0}));
  ClothDef def = sheet(0.5f, 0.5f, 9, 9, {1, 1, 0});
  def.velocity = {0.5f, 0, 0};
  const ClothId new_one = made.create_cloth(def);
  const ClothId id = world_.create_cloth(sheet(0.5f, 0.5f, 9, 9, {0, 2, 0}));
  run(world_, 5, snapshot_step);
  const std::vector<Vec3> to = copy_of(made.cloth_positions(new_one));
  world_.set_cloth_positions(id, to);
  world_.set_cloth_velocities(id, made.cloth_velocities(new_one));
  EXPECT_EQ(copy_of(world_.cloth_positions(id)), to);
  EXPECT_EQ(copy_of(world_.cloth_normals(id)), copy_of(made.cloth_normals(new_one)));
  for (int k = 0; k < 12; ++k) {
    made.step(snapshot_step), world_.step(snapshot_step);
    EXPECT_EQ(world_.state_hash(), made.state_hash());
  }
}

TEST_P(SetClothTest, TheSameVelocitiesLeaveTheFuture) {
  const auto make = [&] {
    World world(world_def(GetParam(), 0.1f));
    const ClothId id = world.create_cloth(sheet(0.5f, 0.5f, 9, 9, {0, 1, 0}));
    world.create_attachment(attach(id, {0, 8}));
    world.create_rope(rope({{1, 1, 0}, {1.5f, 1, 0}}, 6));
    run(world, 8, snapshot_step);
    return world;
  };
  World one = make(), other = make();
  other.set_cloth_velocities(other.cloth_ids()[0], other.cloth_velocities(other.cloth_ids()[0]));
  other.set_rope_velocities(other.rope_ids()[0], other.rope_velocities(other.rope_ids()[0]));
  EXPECT_EQ(future_of(other, steps), future_of(one, steps));
}

TEST_P(SetClothTest, HeldVerticesAreHeldInTheirNewPlace) {
  const ClothId id = world_.create_cloth(sheet(0.5f, 0.5f, 5, 5, {0, 1, 0}));
  world_.create_attachment(attach(id, {0, 4}));
  run(world_, 3, snapshot_step);
  const std::vector<Vec3> to = shifted(world_.cloth_positions(id), {0, 0, 1});
  world_.set_cloth_positions(id, to);
  world_.set_cloth_velocities(id, std::vector<Vec3>(to.size(), {0, 0, 3}));
  run(world_, 3, snapshot_step);
  EXPECT_EQ(world_.cloth_positions(id)[0], to[0]);
  EXPECT_EQ(world_.cloth_positions(id)[4], to[4]);
  EXPECT_EQ(world_.cloth_velocities(id)[0], (Vec3{0, 0, 0}));
  EXPECT_LT(world_.cloth_positions(id)[12].y, to[12].y);
}

/// A free piece moves on as it is told.
TEST_P(SetClothTest, VelocitiesCarryARope) {
  WorldDef def = world_.def();
  def.gravity = {0, 0, 0};
  world_.set_def(def);
  const RopeId id = world_.create_rope(rope({{0, 1, 0}, {0.5f, 1, 0}}, 5));
  world_.step(snapshot_step);
  const std::vector<Vec3> before = copy_of(world_.rope_positions(id));
  world_.set_rope_velocities(id, std::vector<Vec3>(before.size(), {0, 2, 0}));
  world_.step(0.1f);
  for (size_t v = 0; v < before.size(); ++v)
    EXPECT_NEAR(length(world_.rope_positions(id)[v] - before[v] - Vec3{0, 0.2f, 0}), 0, 1e-5f);
}

/// Frames follow, so that a straight rod that was turned as a whole stays straight and at rest.
TEST_P(SetClothTest, FramesOfARodTurnWithIt) {
  WorldDef def = world_.def();
  def.gravity = {0, 0, 0};
  world_.set_def(def);
  RopeDef rod = rope({{0, 1, 0}, {0.5f, 1, 0}}, 5);
  rod.bends_and_twists = true;
  const RopeId id = world_.create_rope(rod);
  world_.step(snapshot_step);
  std::vector<Vec3> upright;
  for (int k = 0; k < 6; ++k) upright.push_back({0, 1 + 0.1f * static_cast<float>(k), 0});
  world_.set_rope_positions(id, upright);
  for (const Quat& frame : world_.rope_frames(id))
    EXPECT_NEAR(length(rotate(frame, {0, 0, 1}) - Vec3{0, 1, 0}), 0, 1e-5f);
  run(world_, 5, snapshot_step);
  for (size_t v = 0; v < upright.size(); ++v)
    EXPECT_NEAR(length(world_.rope_positions(id)[v] - upright[v]), 0, 1e-4f);
}

MENISCUS_ON_EACH_DEVICE(SetClothTest);

}  // namespace
}  // namespace meniscus::tests
