// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "fluid/forces/viscosity_pass.inl"
#include "pbd/device/cuda/cuda_device.cuh"

template class meniscus::fluid::ViscosityPass<meniscus::pbd::CudaDevice>;
