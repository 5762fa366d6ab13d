// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Makes the baselines.
#pragma once

#include "fluid/baselines/dfsph.h"
#include "fluid/baselines/pcisph.h"
#include "fluid/baselines/wcsph.h"

namespace meniscus::fluid {

template <class D>
std::unique_ptr<Baseline<D>> make_baseline(D& device, const Kernel& kernel,
                                           const DensityParameters& parameters) {
  switch (parameters.method) {
    case DensityMethod::pcisph:
      return std::make_unique<Pcisph<D>>(device, kernel, parameters);
    case DensityMethod::wcsph:
      return std::make_unique<Wcsph<D>>(device, kernel, parameters);
    case DensityMethod::dfsph:
      return std::make_unique<Dfsph<D>>(device, kernel, parameters);
    default:
      return nullptr;
  }
}

}  // namespace meniscus::fluid
