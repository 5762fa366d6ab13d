// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates ShapeContacts and ContactSet for CUDA.
#include "collision/contact/contact_set.inl"
#include "collision/contact/shape_contacts.inl"
#include "pbd/device/cuda/cuda_device.cuh"

template class meniscus::collision::ShapeContacts<meniscus::pbd::CudaDevice>;
template class meniscus::collision::ContactSet<meniscus::pbd::CudaDevice>;
