// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates Anisotropy for the GPU.
#include "fluid/surface/anisotropy.inl"
#include "pbd/device/cuda/cuda_device.cuh"

template class meniscus::fluid::Anisotropy<meniscus::pbd::CudaDevice>;
