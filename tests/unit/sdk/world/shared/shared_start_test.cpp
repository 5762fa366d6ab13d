// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// How a world on several ranks starts: its particles wait on the host, and a device gets those of its rank.
#include <gtest/gtest.h>

#include <atomic>
#include <mutex>

#include "tests/ranks/share.h"

namespace meniscus::tests {
namespace {

constexpr float frame = 0.008f;  // s

class SharedStart : public OnDevice {
 protected:
  World channel(const std::function<void(World&)>& prepare, float length = 3) const {
    WorldDef def = world_def(GetParam(), 0.05f);
    def.sums = Sums::fixed;
    def.threads = 1;
    World world(def);
    prepare(world);
    const FluidId a = world.create_fluid({}), b = world.create_fluid({.rest_density = 500});
    world.create_shape(tank({0, 0, 0}, {0.4f, 1, length + 0.5f}));
    world.add_fluid(block(a, {0, 0, 0}, {0.4f, 0.3f, length}));
    FluidVolumeDef above = block(b, {0, 0.2f, 0}, {0.4f, 0.5f, length});  // its lower third is taken
    above.velocity = {0, 0, 1};
    world.add_fluid(above);
    return world;
  }
  World held_channel() const { return channel(SharedWorld::hold_back); }

  static std::vector<std::string> told(World& world) {
    std::vector<std::string> all;
    for (int k = 0; k < 6; ++k) {
      world.step(frame);
      all.push_back(std::to_string(world.state_hash()) + " " + std::to_string(world.ids().back()));
    }
    return all;
  }
};

TEST_P(SharedStart, HeldBackParticlesHaveTheBitsOfAWorldAlone) {
  World alone = channel([](World&) {});
  const std::vector<std::string> expected = told(alone);
  for (const int ranks : {1, 2, 3}) {
    SCOPED_TRACE(ranks);
    std::vector<std::string> found;
    const auto errors = share(
        ranks, {}, [&] { return held_channel(); }, [&](World& world) { found = told(world); });
    for (const std::string& error : errors) EXPECT_EQ(error, "");
    EXPECT_EQ(found, expected);
  }
}

TEST_P(SharedStart, AFileHasRoomForTheParticlesOfAllRanks) {
  const std::string file = testing::TempDir() + "/shared_start.menisnap";
  std::vector<std::string> expected;
  const auto errors = share(
      3, {}, [&] { return held_channel(); },
      [&](World& world) {
        world.step(frame);
        world.save(file);
        expected = told(world);
      });
  for (const std::string& error : errors) EXPECT_EQ(error, "");
  World alone = World::load(file);
  EXPECT_EQ(told(alone), expected);
}

TEST_P(SharedStart, ACallThatNeedsThemBringsThemToTheDevice) {
  World held = held_channel(), plain = channel([](World&) {});
  EXPECT_EQ(held.particle_count(), plain.particle_count());
  EXPECT_LT(held.device_bytes(), plain.device_bytes() / 10);
  EXPECT_EQ(held.state_hash(), plain.state_hash());
  EXPECT_EQ(told(held), told(plain));
}

/// Rank 0 may have looked at the world before.
TEST_P(SharedStart, RanksMayStartInDifferentWays) {
  World alone = channel([](World&) {});
  const std::vector<std::string> expected = told(alone);
  std::atomic<int> made = 0;
  std::vector<std::string> found;
  const auto errors = share(
      3, {},
      [&] {
        World world = held_channel();
        if (made++ == 1) world.diagnostics();
        return world;
      },
      [&](World& world) { found = told(world); });
  for (const std::string& error : errors) EXPECT_EQ(error, "");
  EXPECT_EQ(found, expected);
}

/// The peak of each rank's device, until it has shared the world, is in proportion to its part.
TEST_P(SharedStart, NoDeviceHasTheWholeWorld) {
  constexpr float length = 12;
  const std::size_t whole = channel([](World&) {}, length).memory_stats().device.peak_bytes;
  constexpr int count = 4;
  const auto ranks = make_thread_ranks(count);
  std::mutex mutex;
  std::vector<std::size_t> peaks;
  const auto start = [&](int r) {
    World world = channel(SharedWorld::hold_back, length);
    SharedWorld shared(world, *ranks[static_cast<std::size_t>(r)]);
    const std::scoped_lock lock(mutex);
    peaks.push_back(world.memory_stats().device.peak_bytes);
  };
  {
    std::vector<std::jthread> all;
    for (int r = 0; r < count; ++r) all.emplace_back(start, r);
  }
  ASSERT_EQ(peaks.size(), std::size_t{count});
  for (const std::size_t peak : peaks) EXPECT_LT(peak, whole * 2 / 5);
}

MENISCUS_ON_EACH_DEVICE(SharedStart);

}  // namespace
}  // namespace meniscus::tests
