// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates ClothSolidBenchOn for the CPU.
#include "pbd/device/cpu/cpu_device.h"
#include "tests/bench/harness/cloth_solid_bench.inl"

namespace meniscus::tests {

std::unique_ptr<ClothSolidBench> make_cpu_cloth_solid_bench(const ClothSolidSetup& setup) {
  return std::make_unique<ClothSolidBenchOn<pbd::CpuDevice>>(setup, setup.threads);
}

}  // namespace meniscus::tests
