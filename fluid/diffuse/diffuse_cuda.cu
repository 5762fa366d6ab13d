// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates Diffuse for the GPU.
#include "fluid/diffuse/diffuse.inl"
#include "pbd/device/cuda/cuda_device.cuh"

template class meniscus::fluid::Diffuse<meniscus::pbd::CudaDevice>;
