// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates sdf_error and build_sdf_to_error for the CPU.
#include "collision/sdf/sdf_error.inl"
#include "pbd/device/cpu/cpu_device.h"

namespace meniscus::collision {

template float sdf_error(pbd::CpuDevice&, const TriangleMesh&, const DeviceTriangleBvh&, const Sdf&);
template Sdf build_sdf_to_error(pbd::CpuDevice&, const TriangleMesh&, const DeviceTriangleBvh&, float, float,
                                uint32_t);

}  // namespace meniscus::collision
