// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates BodyAttachments for the CPU.
#include "collision/body/attachments.inl"
#include "pbd/device/cpu/cpu_device.h"

template class meniscus::collision::BodyAttachments<meniscus::pbd::CpuDevice>;
