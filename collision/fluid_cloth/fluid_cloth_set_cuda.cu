// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates FluidClothContacts and FluidClothSet for CUDA.
#include "collision/fluid_cloth/fluid_cloth_set.inl"
#include "pbd/device/cuda/cuda_device.cuh"

template class meniscus::collision::FluidClothContacts<meniscus::pbd::CudaDevice>;
template class meniscus::collision::FluidClothSet<meniscus::pbd::CudaDevice>;
