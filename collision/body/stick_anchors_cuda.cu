// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates StickAnchors for CUDA.
#include "collision/body/stick_anchors.inl"
#include "pbd/device/cuda/cuda_device.cuh"

template class meniscus::collision::StickAnchors<meniscus::pbd::CudaDevice>;
