// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates Solver for the GPU.
#include "pbd/device/cuda/cuda_access.cuh"
#include "pbd/device/cuda/cuda_device.cuh"
#include "pbd/solver/solver.inl"

template class meniscus::pbd::Solver<meniscus::pbd::CudaDevice>;
