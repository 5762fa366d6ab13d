// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The multipliers of particles in pistons, from those of the fluid in front.
#pragma once

#include "fluid/kernel/density_kernels.h"

namespace meniscus::fluid::density_kernels {

/// Gives a particle of a piston the mean of its fluid neighbours' multipliers, weighted by the kernel: λ_i =
/// Σ λ_j W_ij / Σ W_ij. So a piston pushes the fluid as more of that fluid would (Adami, Hu & Adams 2012, eq.
/// 27, without its term for gravity over one support radius). A constraint of its own would ask for the
/// density of a place whose support the duct cuts off.
template <class K>
struct ExtrapolateToPistons {
  K kernel;
  NeighbourView neighbours;
  View<const pbd::Phase> phase;
  View<Vec4> staged;
  View<Multiplier> multiplier;
  bool first;  ///< iteration of the substep

  MENISCUS_HD void operator()(uint32_t i) const {
    if (!(phase[i] & pbd::phase_piston)) return;
    const Vec4 self = staged[i];
    float sum = 0, weights = 0;
    for (uint32_t k = 0; k < neighbours.size(i); ++k) {
      const uint32_t j = neighbours.at(i, k);
      if (j == neighbours.sentinel || (phase[j] & pbd::phase_piston)) continue;
      const Vec4 other = staged[j];
      const Vec3 d = self.xyz() - other.xyz();
      const float weight = kernel.weight(dot(d, d));
      sum += weight * other.w;
      weights += weight;
    }
    const float mean = weights > 0 ? sum / weights : 0.0f;
    staged[i] = pbd::with_w(self.xyz(), mean);
    multiplier[i] = {first ? mean : multiplier[i].value + mean, 0};
  }
};

}  // namespace meniscus::fluid::density_kernels
