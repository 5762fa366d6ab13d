// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates Anisotropy for the CPU.
#include "fluid/surface/anisotropy.inl"
#include "pbd/device/cpu/cpu_device.h"

template class meniscus::fluid::Anisotropy<meniscus::pbd::CpuDevice>;
