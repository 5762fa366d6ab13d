// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Worlds with force fields repeat themselves bit for bit, and snapshots have the fields.
#include <gtest/gtest.h>

#include <filesystem>

#include "sdk/engine/force_fields/curl_noise.h"
#include "tests/many_threads.h"
#include "tests/unit/sdk/world/extension/force_worlds.h"
#include "tests/unit/sdk/world/snapshot/cases.h"

namespace meniscus::tests {
namespace {

/// Water, cloth, a rope, a body and all kinds of fields.
World stirred(const WorldDef& def) {
  World world(def);
  const FluidId water = world.create_fluid({});
  world.create_shape(tank({0, 0, 0}, {1, 1, 0.5f}));
  world.add_fluid(block(water, {0, 0, 0}, {0.5f, 0.6f, 0.5f}));
  world.create_body(brick({0.75f, 0.4f, 0.25f}));
  world.create_cloth(sheet(0.4f, 0.4f, 8, 8, {0.3f, 0.8f, 0.25f}));
  world.create_rope(rope({{0.2f, 0.9f, 0.1f}, {0.6f, 0.9f, 0.1f}}, 6));
  const auto add = [&](const Force& force) {
    ForceFieldDef made = field(force);
    made.pose.position = {0.5f, 0.4f, 0.25f};
    world.create_force_field(made);
  };
  add(UniformForce{{1, 0, 0}});
  add(RadialForce{-0.5f, 0.5f, 2, 0.1f});
  add(VortexForce{2, 1});
  add(DragForce{{0, 0, 1}, 0.2f, 0.1f});
  add(NoiseForce{3, 0.2f, 0.05f, 7});
  add(GridForce{{-0.5f, -0.5f, -0.5f}, 1, 2, 2, 2, std::vector<Vec3>(8, {0, 0.5f, 0})});
  return world;
}

class ForceStateTest : public OnDevice {};

TEST_P(ForceStateTest, TheNumberOfThreadsLeavesNoTrace) {
  if (GetParam() != pbd::DeviceKind::cpu) GTEST_SKIP() << "threads are of the CPU";
  const ManyThreads many;
  std::vector<uint64_t> hashes;
  for (const int threads : {1, 3, 8}) {
    WorldDef def = world_def(GetParam(), 0.05f);
    def.threads = threads;
    World world = stirred(def);
    run(world, 6, snapshot_step);
    hashes.push_back(world.state_hash());
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_EQ(hashes[0], hashes[2]);
}

TEST_P(ForceStateTest, SnapshotsContinueBitForBit) {
  World world = stirred(world_def(GetParam(), 0.05f));
  run(world, 3, snapshot_step);
  const Snapshot snapshot = world.snapshot();
  const auto future = future_of(world, 3);
  for (const ForceFieldId id : world.force_field_ids()) world.destroy_force_field(id);
  world.create_force_field(field(UniformForce{{0, 50, 0}}));
  run(world, 2, snapshot_step);
  world.restore(snapshot);
  EXPECT_EQ(world.force_field_ids().size(), 6u);
  EXPECT_EQ(future_of(world, 3), future);
}

TEST_P(ForceStateTest, FilesContinueBitForBit) {
  World world = stirred(world_def(GetParam(), 0.05f));
  run(world, 3, snapshot_step);
  const std::string path = testing::TempDir() + "force_fields_" + testing::PrintToString(GetParam());
  world.save(path);
  World loaded = World::load(path);
  std::filesystem::remove(path);
  EXPECT_EQ(loaded.force_field_ids().size(), 6u);
  EXPECT_TRUE(loaded.find_force_field("field") == loaded.force_field_ids().front());
  EXPECT_EQ(future_of(loaded, 3), future_of(world, 3));
}

TEST_P(ForceStateTest, AFieldThatCameAndWentLeavesNoTrace) {
  World world = stirred(world_def(GetParam(), 0.05f)), other = stirred(world_def(GetParam(), 0.05f));
  other.destroy_force_field(other.create_force_field(field(UniformForce{{0, 50, 0}})));
  EXPECT_EQ(future_of(other, 3), future_of(world, 3));
}

TEST_P(ForceStateTest, AFailedStepLeavesBodiesAsTheyWere) {
  World world(weightless(GetParam()));
  const FluidId water = world.create_fluid({});
  const BodyId body = world.create_body(brick({0, 0, 0}));
  world.add_particles(water, std::vector<Vec3>{{5, 0, 0}});
  world.create_force_field(field(UniformForce{{1, 0, 0}}));
  run(world, 2, 0.01f);
  const uint64_t before = world.state_hash();
  const Vec3 velocity = world.body_state(body).velocity;
  const ForceFieldId bad = world.create_force_field(field(UniformForce{{3e38f, 3e38f, 0}}));
  EXPECT_THROW(world.step(1), Error);
  EXPECT_EQ(world.state_hash(), before);
  expect_near(world.body_state(body).velocity, velocity, 1e-9f);
  world.destroy_force_field(bad);
  world.step(0.01f);
  expect_near(world.body_state(body).velocity, {0.03f, 0, 0}, 1e-6f);
}

MENISCUS_ON_EACH_DEVICE(ForceStateTest);

TEST(CurlNoise, HasAMeanSquareOfOneAndNoDivergence) {
  std::mt19937 random(3);
  double squares = 0;
  float worst = 0, slope = 0;
  constexpr int samples = 20000;
  constexpr float d = 1.0f / 128;
  for (int k = 0; k < samples; ++k) {
    const Vec3 p = random_vector(random, 500);
    const auto at = [&](Vec3 q) { return force_kernels::curl_noise(q, 5); };
    const Vec3 a = at(p);
    squares += double{dot(a, a)} / samples;
    const Vec3 x = at(p + Vec3{d, 0, 0}) - at(p - Vec3{d, 0, 0}),
               y = at(p + Vec3{0, d, 0}) - at(p - Vec3{0, d, 0}),
               z = at(p + Vec3{0, 0, d}) - at(p - Vec3{0, 0, d});
    worst = std::fmax(worst, std::fabs(x.x + y.y + z.z) / (2 * d));
    slope = std::fmax(slope, std::fabs(x.x) / (2 * d));
  }
  EXPECT_NEAR(squares, 1, 0.03);
  EXPECT_LT(worst, 0.02f * slope);
}

TEST(CurlNoise, OtherSeedsGiveOtherPatterns) {
  double same = 0, product = 0;
  std::mt19937 random(4);
  for (int k = 0; k < 2000; ++k) {
    const Vec3 p = random_vector(random, 50);
    same += double{dot(force_kernels::curl_noise(p, 1), force_kernels::curl_noise(p, 1))};
    product += double{dot(force_kernels::curl_noise(p, 1), force_kernels::curl_noise(p, 2))};
  }
  EXPECT_LT(std::fabs(product), 0.1 * same);
}

}  // namespace
}  // namespace meniscus::tests
