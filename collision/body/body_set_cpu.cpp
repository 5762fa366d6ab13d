// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates BodySet for the CPU.
#include "collision/body/body_set.inl"
#include "pbd/device/cpu/cpu_device.h"

template class meniscus::collision::BodySet<meniscus::pbd::CpuDevice>;
