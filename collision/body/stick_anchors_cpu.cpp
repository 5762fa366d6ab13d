// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates StickAnchors for the CPU.
#include "collision/body/stick_anchors.inl"
#include "pbd/device/cpu/cpu_device.h"

template class meniscus::collision::StickAnchors<meniscus::pbd::CpuDevice>;
