// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates ClothSolidBenchOn for the GPU.
#include "pbd/device/cuda/cuda_device.cuh"
#include "tests/bench/harness/cloth_solid_bench.inl"

namespace meniscus::tests {

std::unique_ptr<ClothSolidBench> make_cuda_cloth_solid_bench(const ClothSolidSetup& setup) {
  return std::make_unique<ClothSolidBenchOn<pbd::CudaDevice>>(setup);
}

}  // namespace meniscus::tests
