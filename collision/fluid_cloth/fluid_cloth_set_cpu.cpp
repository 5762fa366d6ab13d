// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates FluidClothContacts and FluidClothSet for the CPU.
#include "collision/fluid_cloth/fluid_cloth_set.inl"
#include "pbd/device/cpu/cpu_device.h"

template class meniscus::collision::FluidClothContacts<meniscus::pbd::CpuDevice>;
template class meniscus::collision::FluidClothSet<meniscus::pbd::CpuDevice>;
