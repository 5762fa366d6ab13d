// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "collision/fluid_cloth/sheet_set.inl"
#include "pbd/device/cpu/cpu_device.h"

template class meniscus::collision::SheetContacts<meniscus::pbd::CpuDevice>;
template class meniscus::collision::SheetSet<meniscus::pbd::CpuDevice>;
