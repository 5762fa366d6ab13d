// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates SurfaceTensionSet for the GPU.
#include "fluid/forces/surface_tension_set.inl"
#include "pbd/device/cuda/cuda_device.cuh"

template class meniscus::fluid::SurfaceTensionSet<meniscus::pbd::CudaDevice>;
