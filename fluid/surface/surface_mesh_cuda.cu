// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates SurfaceMesher for the GPU.
#include "fluid/surface/surface_mesh.inl"
#include "pbd/device/cuda/cuda_device.cuh"

template class meniscus::fluid::SurfaceMesher<meniscus::pbd::CudaDevice>;
