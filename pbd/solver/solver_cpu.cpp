// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates Solver for the CPU.
#include "pbd/device/cpu/cpu_access.h"
#include "pbd/device/cpu/cpu_device.h"
#include "pbd/solver/solver.inl"

template class meniscus::pbd::Solver<meniscus::pbd::CpuDevice>;
