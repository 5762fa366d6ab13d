// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "fluid/surface_tension_pass.inl"
#include "pbd/device/cpu/cpu_device.h"

template class meniscus::fluid::SurfaceTensionPass<meniscus::pbd::CpuDevice>;
