// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates DensitySet for the CPU.
#include "fluid/density/density_set.inl"
#include "pbd/device/cpu/cpu_device.h"

template class meniscus::fluid::DensitySet<meniscus::pbd::CpuDevice>;
