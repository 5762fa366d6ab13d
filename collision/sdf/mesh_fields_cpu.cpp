// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates MeshFields for the CPU.
#include "collision/sdf/mesh_fields.inl"
#include "pbd/device/cpu/cpu_device.h"

namespace meniscus::collision {

template class MeshFields<pbd::CpuDevice>;

}  // namespace meniscus::collision
