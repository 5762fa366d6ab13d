// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates RodBenchOn for the GPU.
#include "pbd/device/cuda/cuda_device.cuh"
#include "tests/bench/harness/rod_bench.inl"

namespace meniscus::tests {

std::unique_ptr<RodBench> make_cuda_rod_bench(const RodScene& scene) {
  return std::make_unique<RodBenchOn<pbd::CudaDevice>>(scene);
}

}  // namespace meniscus::tests
