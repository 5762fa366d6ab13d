// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates ViscosityPass for the CPU.
#include "fluid/forces/viscosity_pass.inl"
#include "pbd/device/cpu/cpu_device.h"

template class meniscus::fluid::ViscosityPass<meniscus::pbd::CpuDevice>;
