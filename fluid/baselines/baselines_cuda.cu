// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Instantiates the baselines for the GPU.
#include "fluid/baselines/baselines.inl"
#include "pbd/device/cuda/cuda_device.cuh"

namespace meniscus::fluid {

template std::unique_ptr<Baseline<pbd::CudaDevice>> make_baseline(pbd::CudaDevice&, const Kernel&,
                                                                  const DensityParameters&);

}  // namespace meniscus::fluid
