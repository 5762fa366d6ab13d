// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates BodyZones for CUDA.
#include "collision/body/body_zones.inl"
#include "pbd/device/cuda/cuda_device.cuh"

template class meniscus::collision::BodyZones<meniscus::pbd::CudaDevice>;
