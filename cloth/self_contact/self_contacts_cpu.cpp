// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates SelfContacts for the CPU.
#include "cloth/self_contact/self_contacts.inl"
#include "pbd/device/cpu/cpu_device.h"

template class meniscus::pbd::SurfaceTree<meniscus::pbd::CpuDevice>;
template class meniscus::cloth::SelfContacts<meniscus::pbd::CpuDevice>;
