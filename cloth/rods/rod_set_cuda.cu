// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates RodSet for CUDA.
#include "cloth/rods/rod_set.inl"
#include "pbd/device/cuda/cuda_device.cuh"

template class meniscus::cloth::RodSet<meniscus::pbd::CudaDevice>;
