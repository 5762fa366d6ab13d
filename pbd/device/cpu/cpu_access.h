// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What of the CPU device others may use.
#pragma once

#include <cstdlib>

#include "pbd/device/access.h"
#include "pbd/device/cpu/cpu_device.h"

namespace meniscus::pbd {

template <>
struct DeviceAccess<CpuDevice> {
  static int ordinal(const CpuDevice&) { return 0; }
  static void* stream(CpuDevice&) { return nullptr; }
  static std::shared_ptr<void> allocate(std::size_t bytes) {
    constexpr std::size_t line = 64;
    return {std::aligned_alloc(line, (bytes + line - 1) / line * line),
            [](void* memory) { std::free(memory); }};
  }
};

}  // namespace meniscus::pbd
