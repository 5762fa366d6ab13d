// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A million particles fit a small GPU: what a world holds on the device, once a dam break has come to need
// its most.
#include "tests/validation/measures.h"
#include "tests/validation/scenes.h"

namespace meniscus::tests {
namespace {

TEST(GpuMemory, AMillionParticles) {
  if (!pbd::cuda_status().usable) GTEST_SKIP() << pbd::cuda_status().reason;
  World world = large_dam_break(world_def(pbd::DeviceKind::cuda, 0.023f));
  ASSERT_GE(world.particle_count(), 1'000'000u);
  record_device(world);
  double most = 0;
  for (int frame = 0; frame < 100; ++frame) {
    world.step(frame_time);
    world.diagnostics();  // what looks at the state may need room too
    most = std::max(most, static_cast<double>(world.device_bytes()));
  }
  const double bytes = most / static_cast<double>(world.particle_count());
  record("bytes_a_particle", bytes);
  EXPECT_LE(bytes, 700);
}

}  // namespace
}  // namespace meniscus::tests
