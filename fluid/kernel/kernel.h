// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The smoothing kernels, calibrated for a rest spacing and a support radius. With q = r/h:
//   poly6_spiky   W = 315/(64 π h³) (1 − q²)³              |∇W| = 45/(π h⁴) (1 − q)², of spiky
//   wendland_c2   W = 21/(2 π h³) (1 − q)⁴ (1 + 4q)        |∇W| = 210/(π h⁴) q (1 − q)³
//   cubic_spline  W = 8/(π h³) (2 (1 − q)³ − 8 (½ − q)₊³)  |∇W| = 48/(π h⁴) ((1 − q)² − 4 (½ − q)₊²)
// Müller, Charypar & Gross 2003; Wendland 1995; Monaghan 1992.
//
// They are calibrated on a packing at rest:
//   volume V      Σ V W = 1, the particle itself included;
//   gradient      Σ V |∇W| z²/r = 1, so that a uniform multiplier presses like the pressure that it stands
//   for.
// The packing of poly6_spiky is the cubic lattice. So a lattice at rest has C = 0 to rounding. The packing of
// the others is relaxed and disordered (packing.h), as water is once it has moved.
#pragma once

#include <meniscus/defs.h>

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
  SmoothingKernel shape;
  float h, h2;            ///< support radius, m, and its square
  float volume;           ///< V of W, m³
  float particle_volume;  ///< m³: what pressure acts on; s³, but V of poly6_spiky
  float slope_volume;     ///< m³, the volume in V ∇W of weight_slope()
  float poly6;            ///< poly6_spiky: V · 315 / (64 π h⁹)
  float rest_gradient2;   ///< Σ (V |∇W|)² over the packing, 1/m²
  float inverse_h2;       ///< 1/h²
  float peak_weight;      ///< V W at r = 0
  float peak_slope;       ///< V |∇W| over slope_shape, 1/m
  float peak_pull;        ///< peak_slope / h, 1/m²
  float greatest_slope;   ///< the greatest V |∇W|, 1/m
  float spectral_bound;   ///< of D⁻¹A in the packing, with a margin; poly6_spiky: 0, unknown

  // Loops over neighbours sum the kernels' shapes over t = (r/h)². The factors are the same for all pairs, so
  // they are applied to the sums:
  //   V W = peak_weight · weight_shape(t, 1/√t)      V |∇W| = peak_slope · slope_shape(t, 1/√t)
  //   V |∇W| (x_i − x_j)/r = peak_pull · slope_shape(t, 1/√t)/√t · (x_i − x_j)

  /// t at x_i − x_j = d, plus a small offset, so that 1/√t is finite.
  template <class R>
  MENISCUS_HD R distance_ratio2(const Vec3Of<R>& d) const {
    return R(inverse_h2) * dot(d, d) + R(tiny_ratio2);
  }
};

/// A kernel whose shape is known at compile time, as loops over neighbours need it.
template <SmoothingKernel shape>
struct ShapedKernel;

template <>
struct ShapedKernel<SmoothingKernel::poly6_spiky> : Kernel {
  template <class R>
  MENISCUS_HD static R weight_shape(const R& t) {
    const R u = unit_part(R(1.0f) - t);
    return u * u * u;
  }
  template <class R>
  MENISCUS_HD static R weight_shape(const R& t, const R& /*inverse_root*/) {
    return weight_shape(t);
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

/// What follows from the shapes where W and ∇W are one kernel. `Shape` has weight and slope of u = 1 − q.
template <class Shape>
struct ConsistentKernel : Kernel {
  template <class R>
  MENISCUS_HD static R weight_shape(const R& t, const R& inverse_root) {
    return Shape::weight(unit_part(R(1.0f) - t * inverse_root));
  }
  template <class R>
  MENISCUS_HD static R weight_shape(const R& t) {
    return weight_shape(t, inverse_sqrt(t));
  }
  template <class R>
  MENISCUS_HD static R slope_shape(const R& t, const R& inverse_root) {
    return Shape::slope(unit_part(R(1.0f) - t * inverse_root));
  }
  template <class R>
  MENISCUS_HD R weight(const R& r2) const {
    return R(peak_weight) * weight_shape(ratio2(r2));
  }
  template <class R>
  MENISCUS_HD R weight_slope(const R& r2) const {
    const R t = ratio2(r2), inverse_root = inverse_sqrt(t);
    return R(-peak_pull) * (slope_shape(t, inverse_root) * inverse_root);
  }

 private:
  template <class R>
  MENISCUS_HD R ratio2(const R& r2) const {
    return R(inverse_h2) * r2 + R(tiny_ratio2);
  }
};

struct WendlandShape {
  template <class R>
  MENISCUS_HD static R weight(const R& u) {
    const R u2 = u * u;
    return u2 * u2 * (R(5.0f) - R(4.0f) * u);
  }
  template <class R>
  MENISCUS_HD static R slope(const R& u) {
    return (R(1.0f) - u) * (u * u * u);
  }
};

struct SplineShape {
  template <class R>
  MENISCUS_HD static R weight(const R& u) {
    const R v = unit_part(u - R(0.5f));
    return R(2.0f) * (u * u * u) - R(8.0f) * (v * v * v);
  }
  template <class R>
  MENISCUS_HD static R slope(const R& u) {
    const R v = unit_part(u - R(0.5f));
    return u * u - R(4.0f) * (v * v);
  }
};

template <>
struct ShapedKernel<SmoothingKernel::wendland_c2> : ConsistentKernel<WendlandShape> {};
template <>
struct ShapedKernel<SmoothingKernel::cubic_spline> : ConsistentKernel<SplineShape> {};

/// A kernel of this shape, for loops.
template <SmoothingKernel shape>
ShapedKernel<shape> shaped(const Kernel& kernel) {
  ShapedKernel<shape> result;
  static_cast<Kernel&>(result) = kernel;
  return result;
}

/// Calls f with the kernel in its compile-time shape.
template <class F>
decltype(auto) with_shape(const Kernel& kernel, const F& f) {
  switch (kernel.shape) {
    case SmoothingKernel::wendland_c2:
      return f(shaped<SmoothingKernel::wendland_c2>(kernel));
    case SmoothingKernel::cubic_spline:
      return f(shaped<SmoothingKernel::cubic_spline>(kernel));
    case SmoothingKernel::poly6_spiky:
      break;
  }
  return f(shaped<SmoothingKernel::poly6_spiky>(kernel));
}

/// Integrals of W, whatever its support radius.
struct KernelMoments {
  double second;  ///< ∫ W r² / h²
  double edge;    ///< h ∫ W over a plane through its centre
};

KernelMoments moments_of(SmoothingKernel shape);

/// The kernel for rest spacing s and support radius h, both in m.
Kernel calibrate(double spacing, double support_radius, SmoothingKernel shape = SmoothingKernel::poly6_spiky);

}  // namespace meniscus::fluid
