// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// In a splash, the particles of CPU and GPU diverge; the measured results must not.
#include "tests/validation/measures.h"
#include "tests/validation/scenes.h"

namespace meniscus::tests {
namespace {

TEST(GpuAgreement, LargeDamBreakAfterTwoSeconds) {
  if (!pbd::cuda_status().usable) GTEST_SKIP() << pbd::cuda_status().reason;
  World cpu = large_dam_break(world_def(pbd::DeviceKind::cpu, 0.05f));
  World gpu = large_dam_break(world_def(pbd::DeviceKind::cuda, 0.05f));
  record_device(gpu);
  for (World* world : {&cpu, &gpu}) run(*world, 125, frame_time);
  const double height = std::fabs(mean_height(gpu) / mean_height(cpu) - 1);
  const double energies = std::fabs(energy(gpu) / energy(cpu) - 1);
  record("height_difference_percent", 100 * height);
  record("energy_difference_percent", 100 * energies);
  EXPECT_LE(height, 0.01);
  EXPECT_LE(energies, 0.01);
}

}  // namespace
}  // namespace meniscus::tests
