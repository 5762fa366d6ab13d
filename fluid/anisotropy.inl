// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "fluid/anisotropy.h"
#include "fluid/kernel.h"
#include "fluid/principal_axes.h"

namespace meniscus::fluid {

namespace anisotropy_kernels {

using pbd::Vec3Of;

/// Sums over neighbours at the offsets d from a particle: Σ w, Σ w d and Σ w d dᵀ.
template <class R>
struct Moments {
  float inverse_support;
  R weight{0.0f}, xx{0.0f}, yy{0.0f}, zz{0.0f}, xy{0.0f}, xz{0.0f}, yz{0.0f};
  Vec3Of<R> first{R(0.0f), R(0.0f), R(0.0f)};

  MENISCUS_HD void add(const Vec3Of<R>& d) {
    const R r2 = max(dot(d, d), R(tiny_distance2));
    const R q = R(inverse_support) * (r2 * inverse_sqrt(r2));
    const R w = max(R(1.0f) - q * q * q, R(0.0f));
    const Vec3Of<R> wd = w * d;
    weight += w;
    first += wd;
    xx += wd.x * d.x;
    yy += wd.y * d.y;
    zz += wd.z * d.z;
    xy += wd.x * d.y;
    xz += wd.x * d.z;
    yz += wd.y * d.z;
  }
};

/// The ellipsoid of a particle at x. `m` is the mean offset and `c` the covariance; `share` is 0 for a
/// particle on its own and 1 among neighbours.
MENISCUS_HD inline Ellipsoid ellipsoid_of(const AnisotropyParameters& p, Vec3 x, Vec3 m, const Symmetric3& c,
                                          float share) {
  const PrincipalAxes axes = principal_axes(c);
  Vec3 radii{sqrtf(pbd::max(axes.values.x, 0)), sqrtf(pbd::max(axes.values.y, 0)),
             sqrtf(pbd::max(axes.values.z, 0))};
  const float longest = max_component(radii);
  if (longest > 0) {
    const float least = longest / p.ratio;
    radii = max(radii, {least, least, least});
    radii = radii / cbrtf(radii.x * radii.y * radii.z);
  } else {
    radii = {1, 1, 1};
  }
  const float lone = (1 - share) * p.lone_radius;
  return {x + (share * p.smoothing) * m, (share * p.radius) * radii + Vec3{lone, lone, lone}, axes.rotation};
}

template <class D>
struct Measure {
  AnisotropyParameters parameters;
  pbd::View<const pbd::Vec4> position;
  pbd::NeighbourView neighbours;
  pbd::View<const pbd::Phase> phase;
  pbd::View<const uint32_t> slot;
  pbd::View<Ellipsoid> ellipsoids;

  MENISCUS_HD void operator()(uint32_t i) const {
    using Real = typename D::Real;
    const Vec3 x = position[i].xyz();
    if (pbd::is_grain(phase[i])) {
      const float r = parameters.grain_radius;
      ellipsoids[slot[i]] = {x, {r, r, r}, {0, 0, 0, 1}};
      return;
    }
    Moments<Real> s{1 / parameters.support};
    pbd::for_each_neighbour<D>(neighbours, i, [&](auto j) { s.add(gather(position, j).xyz() - x); });
    const float weight = 1 + sum(s.weight), inverse = 1 / weight;  // with itself, at offset 0
    const Vec3 m = inverse * sum(s.first);
    const Symmetric3 c{inverse * sum(s.xx) - m.x * m.x, inverse * sum(s.yy) - m.y * m.y,
                       inverse * sum(s.zz) - m.z * m.z, inverse * sum(s.xy) - m.x * m.y,
                       inverse * sum(s.xz) - m.x * m.z, inverse * sum(s.yz) - m.y * m.z};
    // From a sixth of what a flat surface has, about two neighbours, to more than half of it: a sheet has .6.
    const float share = pbd::clamp(2.6f * (weight / parameters.surface_weight) - 0.44f, 0, 1);
    ellipsoids[slot[i]] = ellipsoid_of(parameters, x, m, c, share);
  }
};

}  // namespace anisotropy_kernels

template <class D>
void Anisotropy<D>::measure(const pbd::Substep<D>& substep, pbd::View<Ellipsoid> ellipsoids) const {
  device_.parallel_for(
      "anisotropy/measure", substep.particles.sorted,
      anisotropy_kernels::Measure<D>{parameters_, substep.particles.position, substep.neighbours,
                                     substep.particles.phase, substep.particles.slot, ellipsoids});
}

}  // namespace meniscus::fluid
