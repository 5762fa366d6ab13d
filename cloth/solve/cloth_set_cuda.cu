// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates ClothSet for CUDA.
#include "cloth/solve/cloth_set.inl"
#include "pbd/device/cuda/cuda_device.cuh"

template class meniscus::cloth::ClothSet<meniscus::pbd::CudaDevice>;
