// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates PressureGrid for the CPU.
#include "fluid/pressure_grid/pressure_grid.inl"
#include "pbd/device/cpu/cpu_device.h"

template class meniscus::fluid::PressureGrid<meniscus::pbd::CpuDevice>;
