// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "collision/body/body_set.inl"
#include "pbd/device/cpu/cpu_device.h"

template class meniscus::collision::BodySet<meniscus::pbd::CpuDevice>;
