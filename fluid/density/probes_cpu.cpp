// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates Probes for the CPU.
#include "fluid/density/probes.inl"
#include "pbd/device/cpu/cpu_device.h"

template class meniscus::fluid::Probes<meniscus::pbd::CpuDevice>;
