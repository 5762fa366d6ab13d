// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The bits of a large dam break are the same run after run, and whatever the number of threads.
#include "tests/many_threads.h"
#include "tests/validation/measures.h"
#include "tests/validation/scenes.h"

namespace meniscus::tests {
namespace {

uint64_t hash_after(const WorldDef& def, int frames) {
  World world = large_dam_break(def);
  run(world, frames, frame_time);
  record("particles", static_cast<double>(world.particle_count()));
  return world.state_hash();
}

class LargeDeterminismTest : public OnDevice {};

TEST_P(LargeDeterminismTest, ThreeRunsAreAlike) {
  const bool gpu = GetParam() == pbd::DeviceKind::cuda;
  const WorldDef def = world_def(GetParam(), gpu ? 0.05f : 0.08f);
  const int frames = gpu ? 100 : 12;
  record_device(World(def));
  const uint64_t first = hash_after(def, frames);
  EXPECT_EQ(hash_after(def, frames), first);
  EXPECT_EQ(hash_after(def, frames), first);
}

MENISCUS_ON_EACH_DEVICE(LargeDeterminismTest);

TEST(LargeCpuDeterminism, TheNumberOfThreadsLeavesNoTrace) {
  const ManyThreads allowed;
  WorldDef def = world_def(pbd::DeviceKind::cpu, 0.08f);
  def.threads = 1;
  const uint64_t one = hash_after(def, 12);
  for (int threads : {2, 3, 8}) {
    def.threads = threads;
    EXPECT_EQ(hash_after(def, 12), one) << threads << " threads";
  }
}

}  // namespace
}  // namespace meniscus::tests
