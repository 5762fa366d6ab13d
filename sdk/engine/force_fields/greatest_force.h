// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A bound on the acceleration by force fields, for the choice of substeps.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "sdk/engine/force_fields/force_field.h"

namespace meniscus::force_kernels {

/// Noise seldom exceeds this many times its RMS.
inline constexpr float noise_peak = 4;

/// The greatest of r/sⁿ⁺¹, at r² = softening²/n, times strength · radiusⁿ; for n < 1 at the furthest place.
inline float greatest_radial(const ForceField& f, float furthest) {
  const auto n = static_cast<float>(f.exponent);
  const float r = n > 0 ? std::fmin(furthest, std::sqrt(f.softening2 / n)) : furthest;
  return length(radial_amount(f, {r, 0, 0}));
}

/// m/s², or N/m³, of one field at the places within `furthest` of its origin. Drag only brakes what is faster
/// than its flow.
inline float greatest_amount(const ForceField& f, float furthest) {
  const float flow = length(f.vector);
  switch (f.kind) {
    case ForceField::Kind::uniform:
      return flow;
    case ForceField::Kind::radial:
      return greatest_radial(f, furthest);
    case ForceField::Kind::vortex:
      return (flow + f.rate) * flow * furthest;
    case ForceField::Kind::drag:
      return (f.rate + f.strength * flow) * flow;
    case ForceField::Kind::noise:
      return noise_peak * std::fabs(f.strength);
    case ForceField::Kind::grid:
      return f.strength;
  }
  return 0;
}

/// m/s², for particles in a box. `density` is the least of theirs, kg/m³.
inline float greatest_acceleration(std::span<const ForceField> fields, float density, Vec3 lower,
                                   Vec3 upper) {
  if (!(lower.x <= upper.x)) return 0;
  float sum = 0;
  for (const ForceField& f : fields) {
    const Vec3 far = max(abs(lower - f.pose.position), abs(upper - f.pose.position));
    const float amount = greatest_amount(f, length(far));
    sum += f.is_per_volume ? amount / density : amount;
  }
  return sum;
}

}  // namespace meniscus::force_kernels
