// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates MeshFields for CUDA.
#include "collision/sdf/mesh_fields.inl"
#include "pbd/device/cuda/cuda_device.cuh"

namespace meniscus::collision {

template class MeshFields<pbd::CudaDevice>;

}  // namespace meniscus::collision
