// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "fluid/surface_tension_pass.inl"
#include "pbd/device/cuda/cuda_device.cuh"

template class meniscus::fluid::SurfaceTensionPass<meniscus::pbd::CudaDevice>;
