// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates ViscositySet for the CPU.
#include "fluid/forces/viscosity_set.inl"
#include "pbd/device/cpu/cpu_device.h"

template class meniscus::fluid::ViscositySet<meniscus::pbd::CpuDevice>;
