// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates RigidContactSet for the CPU.
#include "collision/rigid_contact/rigid_contact_set.inl"
#include "pbd/device/cpu/cpu_device.h"

template class meniscus::collision::RigidContactSet<meniscus::pbd::CpuDevice>;
