// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates FilmSet for CUDA.
#include "collision/film/film_set.inl"
#include "pbd/device/cuda/cuda_device.cuh"

template class meniscus::collision::FilmSet<meniscus::pbd::CudaDevice>;
