// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates points_inside and lattice_points_inside for CUDA.
#include "collision/sdf/mesh_sampling.inl"
#include "pbd/device/cuda/cuda_device.cuh"

namespace meniscus::collision {

template std::vector<uint8_t> points_inside(pbd::CudaDevice&, const DeviceTriangleBvh&,
                                            std::span<const Vec3>);
template std::vector<Vec3> lattice_points_inside(pbd::CudaDevice&, const DeviceTriangleBvh&, float);

}  // namespace meniscus::collision
