// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "collision/grains/grain_set.inl"
#include "pbd/device/cuda/cuda_device.cuh"

template class meniscus::collision::GrainSet<meniscus::pbd::CudaDevice>;
