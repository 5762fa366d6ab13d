// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The errors at which PCISPH and DFSPH end their iterations.
#pragma once

#include "fluid/density/stop_kernels.h"

namespace meniscus::fluid::baseline_kernels {

/// max(C, 0) of one particle.
struct Excess {
  pbd::View<const float> compression;
  pbd::View<const density_kernels::Progress> progress;

  MENISCUS_HD density_kernels::ErrorSum operator()(uint32_t i) const {
    if (progress[0].ended) return {};
    return {double{pbd::max(compression[i], 0.0f)}, 1};
  }
};

/// Merges to the largest error of any particle, which counts once.
struct LargestError {
  MENISCUS_HD density_kernels::ErrorSum operator()(const density_kernels::ErrorSum& a,
                                                   const density_kernels::ErrorSum& b) const {
    return {a.error > b.error ? a.error : b.error, a.fluid | b.fluid};
  }
};

}  // namespace meniscus::fluid::baseline_kernels
