// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates RodBenchOn for the CPU.
#include "pbd/device/cpu/cpu_device.h"
#include "tests/bench/harness/rod_bench.inl"

namespace meniscus::tests {

std::unique_ptr<RodBench> make_cpu_rod_bench(const RodScene& scene, int threads) {
  return std::make_unique<RodBenchOn<pbd::CpuDevice>>(scene, threads);
}

}  // namespace meniscus::tests
