// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "fluid/forces/surface_tension_set.inl"
#include "pbd/device/cuda/cuda_device.cuh"

template class meniscus::fluid::SurfaceTensionSet<meniscus::pbd::CudaDevice>;
