// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates SolverBenchOn for the CPU.
#include "pbd/device/cpu/cpu_device.h"
#include "tests/bench/harness/solver_bench.inl"

namespace meniscus::tests {

std::unique_ptr<SolverBench> make_cpu_solver_bench() {
  return std::make_unique<SolverBenchOn<pbd::CpuDevice>>();
}

std::unique_ptr<SolverBench> make_baseline_solver_bench() {
  return std::make_unique<SolverBenchOn<pbd::CpuDevice, 0, pbd::CpuDevice::Registers::baseline>>();
}

}  // namespace meniscus::tests
