// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates BodyAttachments for CUDA.
#include "collision/body/attachments.inl"
#include "pbd/device/cuda/cuda_device.cuh"

template class meniscus::collision::BodyAttachments<meniscus::pbd::CudaDevice>;
