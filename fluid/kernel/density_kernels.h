// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of the density constraint, for particles that touch no wall. Particles that touch a wall are
// skipped here. density_wall_kernels.h has kernels for them, with mirror ghosts.
#pragma once

#include "fluid/kernel/kernel.h"
#include "pbd/contacts.h"
#include "pbd/neighbours.h"
#include "pbd/particles.h"

namespace meniscus::fluid::density_kernels {

using pbd::ContactView;
using pbd::NeighbourView;
using pbd::Vec3Of;
using pbd::Vec4;
using pbd::View;

/// C and D of one particle.
struct Constraint {
  float value;
  float denominator;  ///< 1/(kg m²)
  Vec3 gradient;      ///< Σ e, 1/m: near 0 where the support is full
};

/// Sums over neighbours, in terms of the kernels' shapes, from which C and D follow.
template <class R>
struct DensitySums {
  R weight{0.0f}, gradient2{0.0f};
  Vec3Of<R> gradient{R(0.0f), R(0.0f), R(0.0f)};

  /// Adds a neighbour at x_i − x_j = d.
  template <class K>
  MENISCUS_HD void add(const K& kernel, const Vec3Of<R>& d, const R& inverse_mass) {
    const R t = kernel.distance_ratio2(d);
    const R inverse_root = inverse_sqrt(t);
    const R e = K::slope_shape(t, inverse_root);
    weight += K::weight_shape(t, inverse_root);
    gradient2 += inverse_mass * (e * e);
    gradient += (e * inverse_root) * d;
  }

  MENISCUS_HD Constraint constraint(const Kernel& kernel, float self_inverse_mass) const {
    const Vec3 g = kernel.peak_pull * sum(gradient);
    return {kernel.peak_weight * (sum(weight) + 1) - 1,
            self_inverse_mass * dot(g, g) + kernel.peak_slope * kernel.peak_slope * sum(gradient2), g};
  }
};

/// K is a ShapedKernel, here and below.
template <class D, class K>
MENISCUS_HD Constraint density_constraint(const K& kernel, View<const Vec4> position,
                                          const NeighbourView& neighbours, uint32_t i) {
  using Real = typename D::Real;
  const Vec4 self = position[i];
  DensitySums<Real> sums;
  pbd::for_each_neighbour<D>(neighbours, i, [&](auto j) {
    const auto other = gather(position, j);
    sums.add(kernel, self.xyz() - other.xyz(), other.w);
  });
  return sums.constraint(kernel, self.w);
}

/// λ of a particle in the present or last substep.
struct alignas(8) Multiplier {
  float value;     ///< kg·m²
  float relieved;  ///< the decrease of C in the substep; during the substep, C at its start. With a pressure
                   ///< grid, the last C
};

/// Multiplier::relieved of a particle whose C is not known yet, with a pressure grid.
constexpr float unmeasured = 3e38f;

/// What an iteration leaves in Multiplier::relieved.
enum class Recorded : uint32_t { error_at_start, decrease, last_error };

// The variants of the kernels, by what a scene has.
enum class WallMotion : bool { none, any };
enum class Grains : bool { absent, present };
enum class Repulsion : bool { off, on };

struct ForgetMultipliers {
  View<Multiplier> multiplier;
  float relieved;

  MENISCUS_HD void operator()(uint32_t i) const { multiplier[i] = {0, relieved}; }
};

/// Adds the multipliers of the pressure grid, so that the sum is the pressure.
struct AddPressure {
  View<const float> found;  ///< kg·m²
  View<Multiplier> multiplier;

  MENISCUS_HD void operator()(uint32_t i) const { multiplier[i].value += found[i]; }
};

/// The update of the multipliers: Δλ = momentum · last Δλ + step · (C − α̃λ)/(D + α̃), λ ≥ 0. The first
/// iteration starts from a fraction of the last substep's λ. It assumes that this fraction reduces C by the
/// same fraction as then, so the start needs no pass of its own. The start is subject to the limit of an
/// iteration. In long substeps the last λ belong to other positions, and without a limit they grew until
/// water at rest became unstable.
struct Advancing {
  View<const Vec4> position;
  View<Multiplier> multiplier;
  View<float> increment;
  View<Vec4> staged;  ///< the position, and in w the part of λ that Correct is to apply
  float momentum, step;
  float compliance;  ///< α̃
  float limit;       ///< m
  bool first;        ///< iteration of the substep
  float fraction;    ///< of the last substep's multiplier
  View<const pbd::Phase> phase;
  Recorded recorded;
  View<const float> allowed{};  ///< the part of C that a particle may keep, if there is a crowd (crowd.h)

  /// Grains have no density constraint of their own. They count in that of the fluid, and its pressure moves
  /// them.
  MENISCUS_HD bool passes_over(uint32_t i) const {
    if (!pbd::is_grain(phase[i])) return false;
    multiplier[i] = {0, 0};
    increment[i] = 0;
    staged[i] = pbd::with_w(position[i].xyz(), 0);
    return true;
  }

  /// Other inputs of advance() for particle i, loaded while the sums over neighbours are computed.
  struct Own {
    Vec4 position;
    Multiplier multiplier;
    float increment;
  };
  MENISCUS_HD Own own(uint32_t i) const { return {position[i], multiplier[i], first ? 0.0f : increment[i]}; }

  MENISCUS_HD void advance(uint32_t i, const Own& own, Constraint c) const {
    if (allowed.count) c.value -= allowed[i];
    const Vec4 p = own.position;
    const Multiplier before = own.multiplier;
    // Both limits hold for the pair: the same λ moves both particles, so momentum is conserved.
    const float bound = limit / sqrtf(pbd::max(p.w * c.denominator, 1e-30f));
    const float kept = first ? pbd::min(fraction, bound / pbd::max(before.value, 1e-30f)) : 1.0f;
    const float old = kept * before.value;
    const float expected = first ? c.value - kept * before.relieved : c.value;
    const float denominator = c.denominator + compliance;
    float change = first ? 0.0f : momentum * own.increment;
    if (denominator > 0) change += step * (expected - compliance * old) / denominator;
    change = pbd::clamp(change, -bound, bound);
    const float next = pbd::max(0.0f, old + change);
    const float start = first ? c.value : before.relieved;
    multiplier[i] = {next, recorded == Recorded::last_error ? c.value
                           : recorded == Recorded::decrease ? start - c.value
                                                            : start};
    increment[i] = next - old;
    staged[i] = pbd::with_w(p.xyz(), first ? next : next - old);
  }
};

template <class K, Grains grains>
struct Advance {
  static constexpr uint32_t resident_blocks = 10;  // see CudaDevice

  K kernel;
  NeighbourView neighbours;
  View<const uint32_t> contact_start;
  Advancing advancing;

  template <class D>
  MENISCUS_HD void run(uint32_t i) const {
    if (contact_start[i] != contact_start[i + 1]) return;
    if (grains == Grains::present && advancing.passes_over(i)) return;
    const auto own = advancing.own(i);
    const Constraint c = density_constraint<D>(kernel, advancing.position, neighbours, i);
    if (D::leads()) advancing.advance(i, own, c);
  }
};

/// The repulsion of eq. 13, as an extra multiplier between each pair.
struct PairPressure {
  float multiplier = 0;      ///< kg·m², where W = W(Δq)
  float inverse_weight = 0;  ///< W(0) / W(Δq)
  int exponent = 4;

  template <class R>
  MENISCUS_HD R at(const R& weight_shape) const {
    const R ratio = weight_shape * R(inverse_weight);
    R power = ratio;
    for (int k = 1; k < exponent; ++k) power = power * ratio;
    return R(multiplier) * power;
  }
};

/// The push of one pair's multipliers, divided by peak_pull · (x_i − x_j), before the inverse mass.
template <class K, Repulsion repulsion, class R>
MENISCUS_HD R push_shape(const PairPressure& pair, const R& t, R multiplier) {
  const R inverse_root = inverse_sqrt(t);
  if constexpr (repulsion == Repulsion::on) multiplier += pair.at(K::weight_shape(t, inverse_root));
  return multiplier * K::slope_shape(t, inverse_root) * inverse_root;
}

/// Moves each particle by the staged multipliers of itself and its neighbours.
template <class K, Repulsion repulsion>
struct Correct {
  static constexpr uint32_t resident_blocks = 10;

  K kernel;
  PairPressure pair;
  View<const Vec4> staged;
  NeighbourView neighbours;
  View<const uint32_t> contact_start;
  View<Vec4> position, accumulated_delta;

  template <class D>
  MENISCUS_HD void run(uint32_t i) const {
    if (contact_start[i] != contact_start[i + 1]) return;
    using Real = typename D::Real;
    const Vec4 self = staged[i], before = accumulated_delta[i];
    Vec3Of<Real> push{Real(0.0f), Real(0.0f), Real(0.0f)};
    pbd::for_each_neighbour<D>(neighbours, i, [&](auto j) {
      const auto other = gather(staged, j);
      const Vec3Of<Real> d = self.xyz() - other.xyz();
      push += push_shape<K, repulsion, Real>(pair, kernel.distance_ratio2(d), Real(self.w) + other.w) * d;
    });
    const Vec3 total = sum(push);
    if (!D::leads()) return;
    const Vec3 step = (before.w * kernel.peak_pull) * total;
    position[i] = pbd::with_w(self.xyz() + step, before.w);
    accumulated_delta[i] = pbd::shifted(before, step);
  }
};

}  // namespace meniscus::fluid::density_kernels
