// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What of a device others may use: its number, its stream, and memory that may outlive it.
#pragma once

#include <cstddef>
#include <memory>

namespace meniscus::pbd {

/// Each device has its own specialisation (cpu/cpu_access.h, cuda/cuda_access.cuh).
template <class D>
struct DeviceAccess {
  /// The CUDA ordinal; 0 on the CPU.
  static int ordinal(const D& device);
  /// For work that is ordered with the device's own: all launches so far are on it. Null on the CPU.
  static void* stream(D& device);
  /// Memory that may outlive the device, and counts for none. Null if there is not enough.
  static std::shared_ptr<void> allocate(std::size_t bytes);
};

}  // namespace meniscus::pbd
