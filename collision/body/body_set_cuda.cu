// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates BodySet for CUDA.
#include "collision/body/body_set.inl"
#include "pbd/device/cuda/cuda_device.cuh"

template class meniscus::collision::BodySet<meniscus::pbd::CudaDevice>;
