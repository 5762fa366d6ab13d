// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What of a GPU device others may use.
#pragma once

#include "pbd/device/access.h"
#include "pbd/device/cuda/cuda_device.cuh"

namespace meniscus::pbd {

template <>
struct DeviceAccess<CudaDevice> {
  static int ordinal(const CudaDevice& device) { return device.ordinal(); }
  static void* stream(CudaDevice& device) { return device.stream_for_others(); }
  static std::shared_ptr<void> allocate(std::size_t bytes) {
    void* const memory = allocate_cuda(bytes);
    if (!memory) return nullptr;
    return {memory, [](void* held) { cudaFree(held); }};
  }
};

}  // namespace meniscus::pbd
