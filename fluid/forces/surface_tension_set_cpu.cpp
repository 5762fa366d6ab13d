// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates SurfaceTensionSet for the CPU.
#include "fluid/forces/surface_tension_set.inl"
#include "pbd/device/cpu/cpu_device.h"

template class meniscus::fluid::SurfaceTensionSet<meniscus::pbd::CpuDevice>;
