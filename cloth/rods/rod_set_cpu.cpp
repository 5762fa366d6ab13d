// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates RodSet for the CPU.
#include "cloth/rods/rod_set.inl"
#include "pbd/device/cpu/cpu_device.h"

template class meniscus::cloth::RodSet<meniscus::pbd::CpuDevice>;
