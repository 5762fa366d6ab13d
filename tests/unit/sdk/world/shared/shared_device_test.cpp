// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// One world on several ranks, on each device, with fixed sums. The ranks are threads. On a GPU all share it,
// and their messages go through the host.
#include <gtest/gtest.h>

#include "tests/ranks/bodies.h"
#include "tests/ranks/broken_dam.h"
#include "tests/ranks/flow.h"
#include "tests/ranks/share.h"

namespace meniscus::tests {
namespace {

constexpr float frame = 0.008f;                // s
constexpr float width = 0.15f, length = 1.3f;  // m

class SharedOnDevice : public OnDevice {
 protected:
  World dam() const {
    const bool is_cuda = GetParam() == pbd::DeviceKind::cuda;
    return broken_dam(width, length, true, is_cuda ? std::optional(0) : std::nullopt, true);
  }
  static std::vector<uint64_t> hashes(World& world) {
    std::vector<uint64_t> all;
    for (int k = 0; k < 12; ++k) {
      world.step(frame);
      if (k % 3 == 2) all.push_back(world.state_hash());
    }
    return all;
  }
  static void expect_the_same(const std::function<World()>& make) {
    World alone = make();
    const std::vector<uint64_t> expected = hashes(alone);
    for (const auto& [ranks, policy] : {std::pair{2, slabs}, std::pair{3, restless_slabs}}) {
      SCOPED_TRACE(ranks);
      std::vector<uint64_t> found;
      const auto errors = share(ranks, policy, make, [&](World& world) { found = hashes(world); });
      for (const std::string& error : errors) EXPECT_EQ(error, "");
      EXPECT_EQ(found, expected);
    }
  }
};

TEST_P(SharedOnDevice, FluidsHaveTheSameBits) {
  expect_the_same([&] { return dam(); });
}

TEST_P(SharedOnDevice, FlowAndBodiesHaveTheSameBits) {
  expect_the_same([&] {
    World world = dam();
    add_flow(world, width, length);
    add_bodies(world, width, length);
    return world;
  });
}

MENISCUS_ON_EACH_DEVICE(SharedOnDevice);

}  // namespace
}  // namespace meniscus::tests
