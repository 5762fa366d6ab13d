// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "collision/body/pressed_vertices.inl"
#include "pbd/device/cpu/cpu_device.h"

template class meniscus::collision::PressedVertices<meniscus::pbd::CpuDevice>;
