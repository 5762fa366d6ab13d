// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The two kernels of Position Based Fluids (Müller, Charypar & Gross 2003): poly6 for sums, spiky for
// gradients.
//   W_poly6(r) = 315 / (64 π h⁹) (h² − r²)³        |∇W_spiky(r)| = 45 / (π h⁶) (h − r)²
//
// They are calibrated on the rest lattice, the cubic one with spacing s. So a fluid at rest has C = 0 to
// rounding, and the multiplier corresponds to pressure:
//   volume V      Σ V W_poly6 = 1, the particle itself included;
//   gradient      Σ V |∇W| z²/r = 1, so that a linear pressure gives its exact gradient.
#pragma once

#include "pbd/device/scalar.h"

namespace meniscus::fluid {

using pbd::inverse_sqrt;
using pbd::max;
using pbd::select_less;
using pbd::sum;
using pbd::unit_part;
using pbd::Vec3Of;

/// Keeps 1/r finite for coincident particles. It is far below a float's resolution at any relevant length. In
/// m², and in h².
inline constexpr float tiny_distance2 = 1e-12f, tiny_ratio2 = 1e-10f;

struct Kernel {
  float h, h2;           ///< support radius, m, and its square
  float volume;          ///< V, m³
  float poly6;           ///< V · 315 / (64 π h⁹)
  float spiky_gradient;  ///< V · 45 / (π h⁶), calibrated, 1/m
  float rest_gradient2;  ///< Σ (V |∇W|)² over the rest lattice, 1/m²
  float inverse_h2;      ///< 1/h²
  float peak_weight;     ///< V W at r = 0
  float peak_slope;      ///< V |∇W| at r = 0, 1/m
  float peak_pull;       ///< peak_slope / h, 1/m²

  // Loops over neighbours sum the kernels' shapes over t = (r/h)². The factors are the same for all pairs, so
  // they are applied to the sums:
  //   V W = peak_weight · weight_shape(t)        V |∇W| = peak_slope · slope_shape(t, 1/√t)
  //   V |∇W| (x_i − x_j)/r = peak_pull · slope_shape(t, 1/√t)/√t · (x_i − x_j)

  /// t at x_i − x_j = d, plus a small offset, so that 1/√t is finite.
  template <class R>
  MENISCUS_HD R distance_ratio2(const Vec3Of<R>& d) const {
    return R(inverse_h2) * dot(d, d) + R(tiny_ratio2);
  }
  template <class R>
  MENISCUS_HD static R weight_shape(const R& t) {
    const R u = unit_part(R(1.0f) - t);
    return u * u * u;
  }
  template <class R>
  MENISCUS_HD static R slope_shape(const R& t, const R& inverse_root) {
    const R q = unit_part(R(1.0f) - t * inverse_root);
    return q * q;
  }

  /// V·W at squared distance r2.
  template <class R>
  MENISCUS_HD R weight(const R& r2) const {
    const R u = max(R(h2) - r2, R(0.0f));
    return R(poly6) * (u * u * u);
  }

  /// V·∇W over x_i − x_j, also of poly6, 1/m².
  template <class R>
  MENISCUS_HD R weight_slope(const R& r2) const {
    const R u = max(R(h2) - r2, R(0.0f));
    return R(-6.0f * poly6) * (u * u);
  }
};

/// The kernel for rest spacing s and support radius h, both in m.
Kernel calibrate(double spacing, double support_radius);

}  // namespace meniscus::fluid
