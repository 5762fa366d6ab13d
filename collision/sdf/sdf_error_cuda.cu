// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates sdf_error and build_sdf_to_error for CUDA.
#include "collision/sdf/sdf_error.inl"
#include "pbd/device/cuda/cuda_device.cuh"

namespace meniscus::collision {

template float sdf_error(pbd::CudaDevice&, const TriangleMesh&, const DeviceTriangleBvh&, const Sdf&);
template Sdf build_sdf_to_error(pbd::CudaDevice&, const TriangleMesh&, const DeviceTriangleBvh&, float, float,
                                uint32_t);

}  // namespace meniscus::collision
