// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates EffectiveMass for the CPU.
#include "collision/body/effective_mass.inl"
#include "pbd/device/cpu/cpu_device.h"

template class meniscus::collision::EffectiveMass<meniscus::pbd::CpuDevice>;
