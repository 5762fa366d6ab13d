// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates SelfContacts for CUDA.
#include "cloth/self_contact/self_contacts.inl"
#include "pbd/device/cuda/cuda_device.cuh"

template class meniscus::pbd::SurfaceTree<meniscus::pbd::CudaDevice>;
template class meniscus::cloth::SelfContacts<meniscus::pbd::CudaDevice>;
