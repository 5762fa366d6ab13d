// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cloth, ropes, fluid and bodies together: the same calls give the same bits.
#include <gtest/gtest.h>

#include <cstring>

#include "tests/cloth_worlds.h"
#include "tests/many_threads.h"
#include "tests/unit/sdk/world/solids/body_worlds.h"

namespace meniscus::tests {
namespace {

/// Water under a sheet that a ball falls into; a folding sheet of triangles; a balloon; a rope with a weight;
/// a rod; a seam; gusts; things that tear.
World busy_world(const WorldDef& def) {
  World world(def);
  world.create_shape(tank({-0.4f, 0, -0.4f}, {0.4f, 2, 0.4f}));
  world.add_fluid(block(world.create_fluid({}), {-0.4f, 0, -0.4f}, {0.4f, 0.2f, 0.4f}));

  ClothDef net = sheet(0.6f, 0.6f, 13, 13, {0, 0.4f, 0}), flap = sheet(0.3f, 0.3f, 7, 7, {0, 0.9f, 0});
  net.fabric.tear_strain = 0.3f;
  net.fabric.warp_stiffness = 500;
  flap.fabric.stretch_model = StretchModel::triangles;
  flap.fabric.bending_model = BendingModel::dihedral;
  flap.pose.rotation = about_z(80);
  ClothDef balloon;
  balloon.geometry = ClothSphere{0.1f, 4};
  balloon.pose.position = {0.2f, 0.6f, 0.1f};
  balloon.inflation = InflationDef{300, 101325};
  const ClothId low = world.create_cloth(net), high = world.create_cloth(flap);
  world.create_cloth(balloon);
  world.create_attachment(attach(low, {0, 12, 156, 168}));
  AttachmentDef seam = attach(high, {0, 1, 2});
  seam.other_cloth = low;
  seam.reach = 0.6f;
  world.create_attachment(seam);

  world.create_body(body(SphereGeometry{0.08f}, {0.05f, 0.55f, 0}));
  RopeDef line = rope({{-0.2f, 1.2f, 0}, {-0.2f, 0.8f, 0}}, 8),
          rod = rope({{0, 1, 0.2f}, {0.3f, 1, 0.2f}}, 8);
  rod.bends_and_twists = true;
  const RopeId leash = world.create_rope(line);
  world.create_rope(rod);
  world.create_attachment(attach(leash, {0}));
  AttachmentDef weight = attach(leash, {8});
  weight.body = world.create_body(body(BoxGeometry{{0.05f, 0.05f, 0.05f}}, {-0.2f, 0.75f, 0}));
  world.create_attachment(weight);
  world.set_wind({.velocity = {2, 0, 1}, .gust_speed = 2});
  return world;
}

uint64_t hash_after(const WorldDef& def, int steps) {
  World world = busy_world(def);
  run(world, steps, 0.016f);
  EXPECT_EQ(world.diagnostics().non_finite, 0u);
  return world.state_hash();
}

class ClothDeterminismTest : public OnDevice {};

TEST_P(ClothDeterminismTest, ThreeRunsAreAlike) {
  const WorldDef def = world_def(GetParam(), 0.05f);
  const uint64_t first = hash_after(def, 25);
  EXPECT_EQ(hash_after(def, 25), first);
  EXPECT_EQ(hash_after(def, 25), first);
}

TEST_P(ClothDeterminismTest, WhatComesAndGoesLeavesNoTraceBesideTheSameInATwin) {
  const auto hash = [&] {
    World world = busy_world(world_def(GetParam(), 0.05f));
    run(world, 5, 0.016f);
    const ClothId late = world.create_cloth(sheet(0.3f, 0.3f, 6, 6, {0, 0.7f, 0}));
    run(world, 5, 0.016f);
    world.destroy_cloth(late);
    run(world, 5, 0.016f);
    return world.state_hash();
  };
  EXPECT_EQ(hash(), hash());
}

// With fluid there is a state that is sorted, from one memory to another; without, all stays in its place.
TEST_P(ClothDeterminismTest, ADropFarAwayLeavesNoTrace) {
  const auto places = [&](bool with_drop) {
    World world(world_def(GetParam(), 0.05f));
    const ClothId id = world.create_cloth(sheet(0.4f, 0.4f, 15, 15, {0, 0.3f, 0}));
    world.create_shape(shape(SphereGeometry{0.15f}));
    if (with_drop) world.add_particles(world.create_fluid({}), std::vector<Vec3>{{5, 50, 5}});
    run(world, 30, 0.016f);
    return copy_of(world.cloth_positions(id));
  };
  const std::vector<Vec3> alone = places(false), beside = places(true);
  EXPECT_LT(alone[112].y, 0.25f);
  EXPECT_EQ(std::memcmp(alone.data(), beside.data(), alone.size() * sizeof(Vec3)), 0);
}

MENISCUS_ON_EACH_DEVICE(ClothDeterminismTest);

TEST(CpuClothDeterminism, TheNumberOfThreadsLeavesNoTrace) {
  const ManyThreads allowed;
  WorldDef def = world_def(pbd::DeviceKind::cpu, 0.05f);
  def.threads = 1;
  const uint64_t one = hash_after(def, 25);
  for (int threads : {2, 3, 8}) {
    def.threads = threads;
    EXPECT_EQ(hash_after(def, 25), one) << threads << " threads";
  }
}

// Sheets that overlap in many more places than there is room for at first.
TEST(CpuClothDeterminism, RelaxingIsTheSameForAnyNumberOfThreads) {
  const ManyThreads allowed;
  const auto hash = [](int threads) {
    WorldDef def = world_def(pbd::DeviceKind::cpu, 0.05f);
    def.threads = threads;
    World world(def);
    for (int k = 0; k < 6; ++k) {
      const auto n = static_cast<float>(k);
      ClothDef cloth = sheet(0.4f, 0.4f, 9, 9, {0.013f * n, 0.004f * n, 0.01f * n});
      cloth.fabric.thickness = 0.02f;
      world.create_cloth(cloth);
    }
    world.relax(5);
    return world.state_hash();
  };
  const uint64_t one = hash(1);
  for (int again = 0; again < 8; ++again) EXPECT_EQ(hash(2 + again % 3), one);
}

class RepeatedStepTest : public OnDevice {};

/// A thrown sheet that is torn at once, and the body that it is attached to. Its lists of pairs have no room
/// at first, and their attempts show too few rounds of the fail-safe. What they show must not change the
/// step.
TEST_P(RepeatedStepTest, IsTheStepThatHasRoom) {
  WorldDef def = world_def(GetParam(), 0.2f);
  def.substeps = 1;
  def.max_substeps = 4;
  def.iterations = 3;
  def.cfl_number = 0.5f;
  World world(def);
  world.create_shape({.name = "tank", .geometry = ContainerGeometry{.half_extents = {1, 1, 1}}});
  ClothDef torn;
  torn.geometry = SheetGeometry{0.42f, 0.736f, 7, 8};
  torn.pose = {{-0.525f, -0.199f, -0.416f}, {0, 0.6f, 0, 0.8f}};
  torn.velocity = {1.136f, 0.513f, 1.558f};
  torn.fabric.tear_strain = 0.1f;
  BodyDef box;
  box.geometry = BoxGeometry{{0.17f, 0.398f, 0.36f}};
  box.pose.position = {0.488f, -1.14f, 0.464f};
  box.velocity = {-2.94f, -1.462f, -2.367f};
  box.density = 1222;
  AttachmentDef held = attach(world.create_cloth(torn), {0, 4});
  held.body = world.create_body(box);
  world.create_attachment(held);
  world.step(1.0f / 60);
  world.step(1e-4f);

  const Snapshot before = world.snapshot();
  world.step(1.0f / 60);  // lists grow
  const uint64_t repeated = world.state_hash();
  world.restore(before);
  world.step(1.0f / 60);
  EXPECT_EQ(world.state_hash(), repeated);
}

MENISCUS_ON_EACH_DEVICE(RepeatedStepTest);

}  // namespace
}  // namespace meniscus::tests
