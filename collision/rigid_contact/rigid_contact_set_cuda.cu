// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates RigidContactSet for CUDA.
#include "collision/rigid_contact/rigid_contact_set.inl"
#include "pbd/device/cuda/cuda_device.cuh"

template class meniscus::collision::RigidContactSet<meniscus::pbd::CudaDevice>;
