// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates DensitySet for the GPU.
#include "fluid/density/density_set.inl"
#include "pbd/device/cuda/cuda_device.cuh"

template class meniscus::fluid::DensitySet<meniscus::pbd::CudaDevice>;
