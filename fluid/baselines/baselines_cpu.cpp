// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates the baselines for the CPU.
#include "fluid/baselines/baselines.inl"
#include "pbd/device/cpu/cpu_device.h"

namespace meniscus::fluid {

template std::unique_ptr<Baseline<pbd::CpuDevice>> make_baseline(pbd::CpuDevice&, const Kernel&,
                                                                 const DensityParameters&);

}  // namespace meniscus::fluid
