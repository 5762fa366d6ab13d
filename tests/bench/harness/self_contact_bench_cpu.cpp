// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates SelfContactBenchOn for the CPU.
#include "pbd/device/cpu/cpu_device.h"
#include "tests/bench/harness/self_contact_bench.inl"

namespace meniscus::tests {

std::unique_ptr<SelfContactBench> make_cpu_self_contact_bench(const ClothCase& cloth, int threads) {
  return std::make_unique<SelfContactBenchOn<pbd::CpuDevice>>(cloth, threads);
}

}  // namespace meniscus::tests
