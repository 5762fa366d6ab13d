// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates GrainSet for the CPU.
#include "collision/grains/grain_set.inl"
#include "pbd/device/cpu/cpu_device.h"

template class meniscus::collision::GrainSet<meniscus::pbd::CpuDevice>;
