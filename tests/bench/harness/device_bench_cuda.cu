// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates DeviceBenchOn for the GPU.
#include "pbd/device/cuda/cuda_device.cuh"
#include "tests/bench/harness/device_bench.inl"

namespace meniscus::tests {

std::unique_ptr<DeviceBench> make_cuda_bench() {
  return std::make_unique<DeviceBenchOn<pbd::CudaDevice>>();
}

}  // namespace meniscus::tests
