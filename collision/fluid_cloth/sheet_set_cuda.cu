// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "collision/fluid_cloth/sheet_set.inl"
#include "pbd/device/cuda/cuda_device.cuh"

template class meniscus::collision::SheetContacts<meniscus::pbd::CudaDevice>;
template class meniscus::collision::SheetSet<meniscus::pbd::CudaDevice>;
