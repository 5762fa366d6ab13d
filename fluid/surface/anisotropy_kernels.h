// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels that fit an ellipsoid to the neighbours of a particle.
#pragma once

#include "fluid/kernel/kernel.h"
#include "fluid/surface/anisotropy.h"
#include "fluid/surface/principal_axes.h"
#include "fluid/surface/tuning.h"

namespace meniscus::fluid::anisotropy_kernels {

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

  /// The sums over all lanes.
  MENISCUS_HD Moments<float> total() const {
    const Vec3 f = sum(first);
    return {inverse_support, sum(weight), sum(xx), sum(yy),        sum(zz),
            sum(xy),         sum(xz),     sum(yz), {f.x, f.y, f.z}};
  }
};

/// The ellipsoid of a particle at x, from the sums over its neighbours without itself.
MENISCUS_HD inline Ellipsoid ellipsoid_of(const AnisotropyParameters& p, Vec3 x, const Moments<float>& s) {
  const float weight = 1 + s.weight, inverse = 1 / weight;  // with the particle itself, at offset 0
  const Vec3 m = inverse * Vec3{s.first.x, s.first.y, s.first.z};
  const Symmetric3 c{inverse * s.xx - m.x * m.x, inverse * s.yy - m.y * m.y, inverse * s.zz - m.z * m.z,
                     inverse * s.xy - m.x * m.y, inverse * s.xz - m.x * m.z, inverse * s.yz - m.y * m.z};
  const float fraction = pbd::clamp(
      surface_tuning::ellipsoid_slope * (weight / p.surface_weight) - surface_tuning::ellipsoid_offset, 0, 1);
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
  const float lone = (1 - fraction) * p.lone_radius;
  return {x + (fraction * p.smoothing) * m, (fraction * p.radius) * radii + Vec3{lone, lone, lone},
          axes.rotation};
}

}  // namespace meniscus::fluid::anisotropy_kernels
