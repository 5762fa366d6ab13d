// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates RopeSet for CUDA.
#include "cloth/rods/rope_set.inl"
#include "pbd/device/cuda/cuda_device.cuh"

template class meniscus::cloth::RopeSet<meniscus::pbd::CudaDevice>;
