// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates ViscosityPass for the GPU.
#include "fluid/forces/viscosity_pass.inl"
#include "pbd/device/cuda/cuda_device.cuh"

template class meniscus::fluid::ViscosityPass<meniscus::pbd::CudaDevice>;
