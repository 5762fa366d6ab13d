// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates ShapeContacts and ContactSet for the CPU.
#include "collision/contact/contact_set.inl"
#include "collision/contact/shape_contacts.inl"
#include "pbd/device/cpu/cpu_device.h"

template class meniscus::collision::ShapeContacts<meniscus::pbd::CpuDevice>;
template class meniscus::collision::ContactSet<meniscus::pbd::CpuDevice>;
