// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates build_sdf for CUDA.
#include "collision/sdf/build.inl"
#include "pbd/device/cuda/cuda_device.cuh"

namespace meniscus::collision {

template Sdf build_sdf(pbd::CudaDevice&, const DeviceTriangleBvh&, float, float);

}  // namespace meniscus::collision
