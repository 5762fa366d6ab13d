// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates Probes for the GPU.
#include "fluid/density/probes.inl"
#include "pbd/device/cuda/cuda_device.cuh"

template class meniscus::fluid::Probes<meniscus::pbd::CudaDevice>;
