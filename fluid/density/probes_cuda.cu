// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "fluid/density/probes.inl"
#include "pbd/device/cuda/cuda_device.cuh"

template class meniscus::fluid::Probes<meniscus::pbd::CudaDevice>;
