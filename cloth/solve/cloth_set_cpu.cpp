// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates ClothSet for the CPU.
#include "cloth/solve/cloth_set.inl"
#include "pbd/device/cpu/cpu_device.h"

template class meniscus::cloth::ClothSet<meniscus::pbd::CpuDevice>;
