// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates Diffuse for the CPU.
#include "fluid/diffuse/diffuse.inl"
#include "pbd/device/cpu/cpu_device.h"

template class meniscus::fluid::Diffuse<meniscus::pbd::CpuDevice>;
