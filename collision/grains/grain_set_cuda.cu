// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates GrainSet for CUDA.
#include "collision/grains/grain_set.inl"
#include "pbd/device/cuda/cuda_device.cuh"

template class meniscus::collision::GrainSet<meniscus::pbd::CudaDevice>;
