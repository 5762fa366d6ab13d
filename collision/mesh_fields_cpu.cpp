// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "collision/mesh_fields.inl"
#include "pbd/device/cpu/cpu_device.h"

namespace meniscus::collision {

template class MeshFields<pbd::CpuDevice>;

}  // namespace meniscus::collision
