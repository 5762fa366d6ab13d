// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates DeviceBenchOn for the CPU.
#include "pbd/device/cpu/cpu_device.h"
#include "tests/bench/harness/device_bench.inl"

namespace meniscus::tests {

std::unique_ptr<DeviceBench> make_cpu_bench(int threads) {
  return std::make_unique<DeviceBenchOn<pbd::CpuDevice>>(threads);
}

}  // namespace meniscus::tests
