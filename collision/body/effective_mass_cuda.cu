// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates EffectiveMass for CUDA.
#include "collision/body/effective_mass.inl"
#include "pbd/device/cuda/cuda_device.cuh"

template class meniscus::collision::EffectiveMass<meniscus::pbd::CudaDevice>;
