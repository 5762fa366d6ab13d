// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates SelfContactBenchOn for the GPU.
#include "pbd/device/cuda/cuda_device.cuh"
#include "tests/bench/harness/self_contact_bench.inl"

namespace meniscus::tests {

std::unique_ptr<SelfContactBench> make_cuda_self_contact_bench(const ClothCase& cloth) {
  return std::make_unique<SelfContactBenchOn<pbd::CudaDevice>>(cloth);
}

}  // namespace meniscus::tests
