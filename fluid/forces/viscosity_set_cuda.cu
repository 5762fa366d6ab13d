// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates ViscositySet for the GPU.
#include "fluid/forces/viscosity_set.inl"
#include "pbd/device/cuda/cuda_device.cuh"

template class meniscus::fluid::ViscositySet<meniscus::pbd::CudaDevice>;
