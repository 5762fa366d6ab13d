// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Long calls can be cancelled, and tell how far they are.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "tests/cloth_worlds.h"
#include "tests/expect_error.h"
#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

class CancelTest : public OnDevice {
 protected:
  using Clock = std::chrono::steady_clock;

  /// A step of this world takes minutes.
  WorldDef long_steps() const {
    WorldDef def = world_def(GetParam(), 0.05f);
    def.substeps = 1000;
    def.iterations = 1000;
    return def;
  }

  /// Cancels the call after 0.2 s, and expects that it ends with the error within a second.
  template <class Call>
  static void expect_cancelled(World& world, const Call& call) {
    std::atomic<Clock::time_point> cancelled{};
    std::thread other([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(200));
      cancelled = Clock::now();
      world.cancel();
    });
    expect_error(ErrorCode::cancelled, "cancelled", call);
    const auto ended = Clock::now();
    other.join();
    EXPECT_LT(std::chrono::duration<double>(ended - cancelled.load()).count(), 1);
  }

  /// A block with many flat faces, of which the field takes long.
  static HullGeometry stone() {
    HullGeometry hull;
    for (int i = 0; i < 200; ++i) {
      const float turn = 2.4f * static_cast<float>(i), y = 2 * (static_cast<float>(i) + 0.5f) / 200 - 1;
      const float r = std::sqrt(1 - y * y);
      hull.points.push_back({r * std::cos(turn), y, r * std::sin(turn)});
    }
    return hull;
  }
};

TEST_P(CancelTest, AStepEndsWithinASecondAndLeavesNoTrace) {
  World world = dam_break(long_steps()), twin = dam_break(world_def(GetParam(), 0.05f));
  const uint64_t hash = world.state_hash();
  expect_cancelled(world, [&] { world.step(0.1f); });
  EXPECT_EQ(world.state_hash(), hash);
  EXPECT_EQ(world.time(), 0);
  world.set_def(world_def(GetParam(), 0.05f));
  run(world, 5, 0.01f);
  run(twin, 5, 0.01f);
  EXPECT_EQ(world.state_hash(), twin.state_hash());
}

/// A substep takes about a millisecond, and much of it goes into sorting and contacts of cloth.
TEST_P(CancelTest, AtAnyMomentAStepLeavesNoTrace) {
  WorldDef def = world_def(GetParam(), 0.05f), long_def = def;
  def.substeps = long_def.iterations = 2;
  long_def.substeps = 1000;
  const auto make = [&] {
    World world(def);
    world.create_shape(tank({0, 0, 0}, {1, 1, 0.5f}));
    world.add_fluid(block(world.create_fluid({}), {0, 0, 0}, {0.5f, 0.4f, 0.5f}));
    for (const float height : {0.7f, 0.701f})
      world.create_cloth(sheet(0.4f, 0.4f, 20, 20, {0.8f, height, 0.25f}));
    run(world, 3, 0.01f);
    return world;
  };
  World world = make(), twin = make();
  const uint64_t hash = world.state_hash();
  world.set_def(long_def);
  for (int k = 0; k < 100; ++k) {
    std::thread other([&] {
      std::this_thread::sleep_for(std::chrono::microseconds(4000 + 31 * k));
      world.cancel();
    });
    expect_error(ErrorCode::cancelled, "cancelled", [&] { world.step(0.1f); });
    other.join();
    ASSERT_EQ(world.state_hash(), hash) << k;
  }
  world.set_def(def);
  run(world, 5, 0.01f);
  run(twin, 5, 0.01f);
  EXPECT_EQ(world.state_hash(), twin.state_hash());
}

TEST_P(CancelTest, AStepWithClothAndBodiesToo) {
  World world(long_steps());
  world.create_shape(tank({0, 0, 0}, {1, 1, 0.5f}));
  world.add_fluid(block(world.create_fluid({}), {0, 0, 0}, {0.5f, 0.4f, 0.5f}));
  world.create_cloth(sheet(0.4f, 0.4f, 40, 40, {0.5f, 0.8f, 0.25f}));
  BodyDef def;
  def.geometry = BoxGeometry{{0.1f, 0.1f, 0.1f}};
  def.pose.position = {0.8f, 0.5f, 0.25f};
  world.create_body(def);
  const uint64_t hash = world.state_hash();
  for (int times = 0; times < 2; ++times) expect_cancelled(world, [&] { world.step(0.1f); });
  EXPECT_EQ(world.state_hash(), hash);
}

// Found as a step that took minutes: each edge was 360 times as long as at rest.
TEST_P(CancelTest, AStepOfClothThatIsStretchedFarToo) {
  WorldDef world_of_sheet = world_def(GetParam(), 0.05f);
  world_of_sheet.substeps = 1000;
  World world(world_of_sheet);
  ClothDef def = sheet(2, 2, 65, 65, {0, 2.4f, 0});
  def.stretch = {360, 1, 1};
  world.create_cloth(def);
  const uint64_t hash = world.state_hash();
  expect_cancelled(world, [&] { world.step(0.016f); });
  EXPECT_EQ(world.state_hash(), hash);
}

TEST_P(CancelTest, ARelaxationKeepsWhatIsDone) {
  World world = dam_break(world_def(GetParam(), 0.05f));
  expect_cancelled(world, [&] { world.relax(100000); });
  run(world, 1, 0.001f);
}

TEST_P(CancelTest, TheFieldOfAMeshToo) {
  if (GetParam() != pbd::DeviceKind::cpu) GTEST_SKIP() << "a GPU takes no second for it";
  World world(world_def(GetParam(), 0.008f));
  const size_t held = world.device_bytes();
  expect_cancelled(world, [&] { world.create_shape(shape(stone())); });
  EXPECT_EQ(world.device_bytes(), held);
  EXPECT_TRUE(world.overlap_ball({0, 0, 0}, 1).shapes.empty());
}

TEST_P(CancelTest, WithoutALongCallTheNextOneEnds) {
  World world = dam_break(world_def(GetParam(), 0.1f));
  world.cancel();
  EXPECT_EQ(world.time(), 0);  // is no long call
  expect_error(ErrorCode::cancelled, "cancelled", [&] { world.step(0.01f); });
  world.step(0.01f);
}

TEST_P(CancelTest, ALongCallTellsHowFarItIsAndMayBeCancelledThen) {
  World world = dam_break(long_steps());
  double last = -1;
  int reports = 0;
  world.set_progress([&](const Progress& progress) {
    EXPECT_STREQ(progress.what, "step");
    EXPECT_GE(progress.fraction, last);
    EXPECT_LT(progress.fraction, 1);
    last = progress.fraction;
    if (++reports == 3) world.cancel();
  });
  expect_error(ErrorCode::cancelled, "cancelled", [&] { world.step(0.1f); });
  EXPECT_EQ(reports, 3);
}

// What one call may cost is bounded.

TEST_P(CancelTest, TheFieldOfALargeHullIsBounded) {
  World world(world_def(GetParam(), 0.01f));
  HullGeometry cube;
  for (int i = 0; i < 8; ++i)
    cube.points.push_back({i & 1 ? 0.5f : -0.5f, i & 2 ? 0.5f : -0.5f, i & 4 ? 0.5f : -0.5f});
  world.create_shape(shape(cube));
  EXPECT_LT(world.device_bytes(), 60u << 20);  // with cells of half a spacing 184 MiB
  const std::vector<Vec3> points{{0.51f, 0, 0}, {0, 0.49f, 0}, {0, 0, 0.2f}, {0.505f, 0.51f, 0}};
  const std::vector<float> exact{0.01f, -0.01f, -0.3f, std::hypot(0.005f, 0.01f)};
  const std::vector<float> found = world.solid_distances(points, 1);
  for (size_t k = 0; k < points.size(); ++k) EXPECT_NEAR(found[k], exact[k], 0.004f) << k;
  ASSERT_EQ(world.warnings().size(), 1u);
  EXPECT_NE(world.warnings()[0].find("takes long"), std::string::npos) << world.warnings()[0];
}

TEST_P(CancelTest, AStepMakesABoundedNumberOfParticles) {
  World world(world_def(GetParam(), 0.01f));
  EmitterDef hose;
  hose.name = "hose";
  hose.fluid = world.create_fluid({});
  hose.opening = RectangleOpening{1, 1};
  hose.speed = 10;
  world.create_emitter(hose);
  expect_error(ErrorCode::capacity, "\"hose\"; a step makes at most 1048576", [&] { world.step(1); });
  EXPECT_EQ(world.time(), 0);
}

MENISCUS_ON_EACH_DEVICE(CancelTest);

}  // namespace
}  // namespace meniscus::tests
