// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates build_density_map for the CPU.
#include "collision/sdf/density_map.inl"
#include "pbd/device/cpu/cpu_device.h"

namespace meniscus::collision {

template void build_density_map(pbd::CpuDevice&, const DeviceTriangleBvh&, Sdf&, float, double);

}  // namespace meniscus::collision
