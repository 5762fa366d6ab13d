// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates RopeSet for the CPU.
#include "cloth/rods/rope_set.inl"
#include "pbd/device/cpu/cpu_device.h"

template class meniscus::cloth::RopeSet<meniscus::pbd::CpuDevice>;
