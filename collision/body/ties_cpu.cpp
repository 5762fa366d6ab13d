// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "collision/body/ties.inl"
#include "pbd/device/cpu/cpu_device.h"

template class meniscus::collision::BodyTies<meniscus::pbd::CpuDevice>;
