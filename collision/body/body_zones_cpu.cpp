// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates BodyZones for the CPU.
#include "collision/body/body_zones.inl"
#include "pbd/device/cpu/cpu_device.h"

template class meniscus::collision::BodyZones<meniscus::pbd::CpuDevice>;
