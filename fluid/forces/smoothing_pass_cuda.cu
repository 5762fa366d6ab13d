// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates SmoothingPass for the GPU.
#include "fluid/forces/smoothing_pass.inl"
#include "pbd/device/cuda/cuda_device.cuh"

template class meniscus::fluid::SmoothingPass<meniscus::pbd::CudaDevice>;
