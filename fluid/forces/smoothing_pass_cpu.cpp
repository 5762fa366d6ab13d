// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates SmoothingPass for the CPU.
#include "fluid/forces/smoothing_pass.inl"
#include "pbd/device/cpu/cpu_device.h"

template class meniscus::fluid::SmoothingPass<meniscus::pbd::CpuDevice>;
