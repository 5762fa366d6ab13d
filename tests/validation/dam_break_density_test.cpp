// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A dam break of 100,000 particles keeps its density while it falls, hits the far wall and splashes.
#include "tests/validation/measures.h"
#include "tests/validation/scenes.h"

namespace meniscus::tests {
namespace {

class DamBreakDensityTest : public OnDevice {};

TEST_P(DamBreakDensityTest, StaysAtRestDensity) {
  World world = large_dam_break(world_def(GetParam(), 0.05f));
  ASSERT_EQ(world.particle_count(), 100'000u);
  record_device(world);
  Watch watch(world);
  DensityErrors errors;
  std::vector<float> frame_ms;
  for (int frame = 0; frame < 60; ++frame) {
    frame_ms.push_back(static_cast<float>(world.step(frame_time).ms));
    const Diagnostics now = world.diagnostics();
    errors.add(world, now);
    watch.add(now);
  }
  record("frame_ms_median", percentile(frame_ms, 0.5));
  errors.record_all();
  watch.expect_sound();
  EXPECT_LE(errors.mean(), 0.20);
  EXPECT_LE(errors.p99(), 1.5);
  EXPECT_LE(errors.worst(), 6);
}

MENISCUS_ON_EACH_DEVICE(DamBreakDensityTest);

}  // namespace
}  // namespace meniscus::tests
