// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates build_density_map for CUDA.
#include "collision/sdf/density_map.inl"
#include "pbd/device/cuda/cuda_device.cuh"

namespace meniscus::collision {

template void build_density_map(pbd::CudaDevice&, const DeviceTriangleBvh&, Sdf&, float, double);

}  // namespace meniscus::collision
