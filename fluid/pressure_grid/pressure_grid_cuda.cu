// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates PressureGrid for the GPU.
#include "fluid/pressure_grid/pressure_grid.inl"
#include "pbd/device/cuda/cuda_device.cuh"

template class meniscus::fluid::PressureGrid<meniscus::pbd::CudaDevice>;
