// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of WCSPH: artificial viscosity and Tait's equation.
#pragma once

#include "fluid/baselines/pressure_kernels.h"
#include "fluid/baselines/tuning.h"

namespace meniscus::fluid::baseline_kernels {

/// The change of a particle's velocity by artificial viscosity.
struct ArtificialViscosity {
  BaselineKernel kernel;
  View<const Vec4> position;  ///< w: inverse mass
  View<const Vec4> velocity;
  float scale;   ///< m³: 2 α (h/2) c_s h_t times the kernel's slope
  float offset;  ///< m²: 0.01 (h/2)²

  /// The term of one neighbour, at d = x_i − x_j, with v = v_i − v_j.
  template <class R>
  MENISCUS_HD Vec3Of<R> term(const Vec3Of<R>& d, const Vec3Of<R>& v, const R& t, float inverse_mass,
                             const R& other_inverse_mass) const {
    const R inverse_root = inverse_sqrt(t);
    const R approach = max(R(0.0f) - dot(v, d), R(0.0f));
    const R shape = BaselineKernel::slope_shape(t, inverse_root) * inverse_root;
    return (R(inverse_mass) * shape * approach /
            ((dot(d, d) + R(offset)) * (R(inverse_mass) + other_inverse_mass + R(tiny)))) *
           d;
  }
  /// Its sum over the neighbours; the lanes are not added up.
  template <class D, class Visit>
  MENISCUS_HD Vec3 sum_over(const NeighbourView& neighbours, uint32_t i, const Visit& visit) const {
    using Real = typename D::Real;
    const Vec4 self = position[i];
    const Vec3 v = velocity[i].xyz();
    Vec3Of<Real> total{Real(0.0f), Real(0.0f), Real(0.0f)};
    pbd::for_each_neighbour<D>(neighbours, i, [&](auto j) {
      const auto other = gather(position, j);
      const Vec3Of<Real> d = self.xyz() - other.xyz(), relative = v - gather(velocity, j).xyz();
      const Real t = kernel.distance_ratio2(d);
      visit(t);
      total += term(d, relative, t, self.w, other.w);
    });
    return scale * sum(total);
  }

  static constexpr float tiny = 1e-30f;  ///< 1/kg, for the sentinel
};

/// C and the viscosity of a particle, in one pass.
struct WcsphSums {
  ArtificialViscosity viscosity;
  NeighbourView neighbours;
  View<const uint32_t> contact_start;
  View<float> compression;
  View<Vec4> change;

  template <class D>
  MENISCUS_HD void run(uint32_t i) const {
    if (contact_start[i] != contact_start[i + 1]) return;
    using Real = typename D::Real;
    Real weight(0.0f);
    const Vec3 v = viscosity.sum_over<D>(neighbours, i,
                                         [&](const Real& t) { weight += BaselineKernel::weight_shape(t); });
    const float c = viscosity.kernel.peak_weight * (sum(weight) + 1) - 1;
    if (!D::leads()) return;
    compression[i] = c;
    change[i] = pbd::with_w(v, 0);
  }
};

struct WcsphSumsAtWalls {
  ArtificialViscosity viscosity;
  CompressAtWalls compress;
  View<Vec4> change;

  template <class D>
  MENISCUS_HD void run(uint32_t k) const {
    compress.run<D>(k);
    const uint32_t i = compress.contacts.touching_particle(k);
    if (i == pbd::no_index) return;
    const Vec3 v = viscosity.sum_over<D>(compress.neighbours, i, [](const typename D::Real&) {});
    if (D::leads()) change[i] = pbd::with_w(v, 0);
  }
};

/// Tait's equation, p = ρ₀ c²/7 ((1 + C)⁷ − 1), never below 0. It stages Λ/(1 + C)², so that the pushes of
/// pairs are m² (p_i/ρ_i² + p_j/ρ_j²) ∇W, and adds the viscosity.
struct ApplyTait {
  View<const float> compression;
  View<const Vec4> change;
  View<const Vec4> position;
  float speed2;   ///< m²/s²: c²; 0: the bulk modulus is given instead
  float modulus;  ///< N·m: V times the bulk modulus
  float dt2;      ///< s²
  View<Multiplier> multiplier;
  View<Vec4> staged, velocity;

  MENISCUS_HD void operator()(uint32_t i) const {
    const float ratio = 1 + compression[i], square = ratio * ratio;
    const float stiffness = modulus + speed2 / position[i].w;
    const float value = dt2 * stiffness * (1.0f / baseline_tuning::tait_exponent) *
                        pbd::max(0.0f, square * square * square * ratio - 1);
    multiplier[i] = {value, 0};
    staged[i].w = value / square;
    velocity[i] = pbd::shifted(velocity[i], change[i].xyz());
  }
};

}  // namespace meniscus::fluid::baseline_kernels
