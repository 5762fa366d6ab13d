// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates SurfaceMesher for the CPU.
#include "fluid/surface/surface_mesh.inl"
#include "pbd/device/cpu/cpu_device.h"

template class meniscus::fluid::SurfaceMesher<meniscus::pbd::CpuDevice>;
