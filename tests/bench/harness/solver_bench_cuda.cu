// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates SolverBenchOn for the GPU.
#include "pbd/device/cuda/cuda_device.cuh"
#include "tests/bench/harness/solver_bench.inl"

namespace meniscus::tests {

std::unique_ptr<SolverBench> make_cuda_solver_bench() {
  return std::make_unique<SolverBenchOn<pbd::CudaDevice>>();
}

}  // namespace meniscus::tests
