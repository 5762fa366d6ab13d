// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates FacePoints for CUDA.
#include "collision/body/face_points.inl"
#include "pbd/device/cuda/cuda_device.cuh"

template class meniscus::collision::FacePoints<meniscus::pbd::CudaDevice>;
