// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates build_sdf for the CPU.
#include "collision/sdf/build.inl"
#include "pbd/device/cpu/cpu_device.h"

namespace meniscus::collision {

template Sdf build_sdf(pbd::CpuDevice&, const DeviceTriangleBvh&, float, float);

}  // namespace meniscus::collision
