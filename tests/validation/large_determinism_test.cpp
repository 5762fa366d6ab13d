// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The bits of a large dam break are the same run after run, and whatever the number of threads; and those of
// a sheet so fine that it crumples.
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

/// A sheet of n² vertices that falls onto a ball.
uint64_t hash_of_drape(WorldDef def, int n, int frames) {
  def.substeps = 12;
  def.iterations = 1;
  def.cloth.stretch_rounds = 4;
  World world(def);
  ShapeDef ball;
  ball.geometry = SphereGeometry{0.5f};
  ball.pose.position = {0, 0.6f, 0};
  world.create_shape({});
  world.create_shape(ball);
  ClothDef sheet;
  sheet.geometry = SheetGeometry{2, 2, n, n};
  sheet.pose.position = {0, 1.2f, 0};
  world.create_cloth(sheet);
  run(world, frames, frame_time);
  EXPECT_EQ(world.diagnostics().non_finite, 0u);
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

// Impact zones grow in parallel: the order of the threads must not matter.
TEST_P(LargeDeterminismTest, ACrumpledSheetComesToTheSameEachTime) {
  const bool gpu = GetParam() == pbd::DeviceKind::cuda;
  const int n = gpu ? 500 : 60, frames = gpu ? 75 : 30;
  const WorldDef def = world_def(GetParam(), 0.05f);
  const uint64_t first = hash_of_drape(def, n, frames);
  EXPECT_EQ(hash_of_drape(def, n, frames), first);
  if (gpu) {
    EXPECT_EQ(hash_of_drape(def, n, frames), first);
  }
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
