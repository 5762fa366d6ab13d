// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Finds the ellipsoids of all particles, as launches of the kernels in anisotropy_kernels.h.
#pragma once

#include "fluid/surface/anisotropy_kernels.h"

namespace meniscus::fluid {

namespace anisotropy_kernels {

template <class D>
struct Measure {
  AnisotropyParameters parameters;
  pbd::View<const pbd::Vec4> position;
  pbd::NeighbourView neighbours;
  pbd::View<const pbd::Phase> phase;
  pbd::View<const uint32_t> slot;  ///< if empty: the sorted order is kept
  pbd::View<Ellipsoid> ellipsoids;

  MENISCUS_HD void operator()(uint32_t i) const {
    using Real = typename D::Real;
    const Vec3 x = position[i].xyz();
    if (pbd::is_grain(phase[i])) {
      const float r = parameters.grain_radius;
      ellipsoids[slot.count ? slot[i] : i] = {x, {r, r, r}, {0, 0, 0, 1}};
      return;
    }
    Moments<Real> s{1 / parameters.support};
    pbd::for_each_neighbour<D>(neighbours, i, [&](auto j) { s.add(gather(position, j).xyz() - x); });
    ellipsoids[slot.count ? slot[i] : i] = ellipsoid_of(parameters, x, s.total());
  }
};

}  // namespace anisotropy_kernels

template <class D>
void Anisotropy<D>::measure(const pbd::Substep<D>& substep, pbd::View<const uint32_t> slot,
                            pbd::View<Ellipsoid> ellipsoids) const {
  device_.parallel_for(
      "anisotropy/measure", substep.particles.sorted,
      anisotropy_kernels::Measure<D>{parameters_, substep.particles.position, substep.neighbours,
                                     substep.particles.phase, slot, ellipsoids});
}

}  // namespace meniscus::fluid
