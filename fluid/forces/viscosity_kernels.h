// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of viscosity_set.h: the viscous forces, and the steps of conjugate gradients.
#pragma once

#include <cmath>

#include "fluid/forces/tuning.h"
#include "fluid/kernel/kernel.h"
#include "pbd/contacts.h"
#include "pbd/neighbours.h"
#include "pbd/particles.h"

namespace meniscus::fluid::viscosity_kernels {

using pbd::Contact;
using pbd::ContactView;
using pbd::NeighbourView;
using pbd::Vec3Of;
using pbd::Vec4;
using pbd::View;

/// The viscosity of a grain in ViscosityOf: it takes that of the fluid beside it.
inline constexpr float of_grain = -1;

/// Copies each fluid's viscosity to its particles.
struct ViscosityOf {
  View<const pbd::Phase> phase;
  View<const float> table;  ///< Pa·s
  View<float> viscosity;

  MENISCUS_HD void operator()(uint32_t i) const {
    viscosity[i] = pbd::is_grain(phase[i]) ? of_grain : table[pbd::phase_group(phase[i])];
  }
};

/// The viscosity between two particles: the harmonic mean, which layers of two fluids have.
template <class R>
MENISCUS_HD R viscosity_between(float self, const R& other) {
  if (self == of_grain) return max(other, R(0.0f));
  const R mean = R(2 * self) * other / (R(self) + max(other, R(0.0f)) + R(1e-30f));
  return select_less(other, R(0.0f), R(self), mean);
}

/// The walls on which fluid does not slip freely.
struct Walls {
  ContactView contacts;       ///< of the fluid
  View<const float> weights;  ///< kg, by contact: see WeighWalls; empty if there are no such walls
  float dt = 0;
  /// By contact on cloth: the velocity of the cloth, or its change. Empty if no cloth takes part.
  View<const Vec4> cloth;

  MENISCUS_HD static Vec3 along(const Contact& c, Vec3 v) { return v - dot(v, c.normal) * c.normal; }
  /// The velocity of the wall of contact k.
  MENISCUS_HD Vec3 velocity(uint32_t k) const {
    const Contact& c = contacts.contacts[k];
    return c.body == pbd::on_cloth ? cloth[k].xyz() : (1 / dt) * c.surface_motion;
  }
  /// The change of that velocity within the solve.
  MENISCUS_HD Vec3 change(uint32_t k) const {
    return contacts.contacts[k].body == pbd::on_cloth ? cloth[k].xyz() : Vec3{0, 0, 0};
  }

  /// Calls visit(contact's number, weight) for each wall that acts on particle i.
  template <class Visit>
  MENISCUS_HD void for_each(uint32_t i, const Visit& visit) const {
    if (weights.count == 0) return;
    for (uint32_t k = contacts.start[i]; k < contacts.start[i + 1]; ++k) {
      const float a = weights[k];
      if (a > 0) visit(k, a);
    }
  }
};

/// h_t A: the viscous impulses at given velocities, with the sign of a brake.
template <bool uniform>
struct Forces {
  Kernel kernel;
  float scale;  ///< kg/(Pa·s)
  float common_viscosity;
  View<const float> viscosity;
  View<const Vec4> position;
  NeighbourView neighbours;
  Walls walls;

  MENISCUS_HD float viscosity_of(uint32_t i) const { return uniform ? common_viscosity : viscosity[i]; }

  /// Of particle i with its neighbours.
  template <class D>
  MENISCUS_HD Vec3 between_pairs(uint32_t i, View<const Vec4> velocity) const {
    using Real = typename D::Real;
    const Vec4 p = position[i], v = velocity[i];
    const float self = viscosity_of(i);
    Vec3Of<Real> total{Real(0.0f), Real(0.0f), Real(0.0f)};
    pbd::for_each_neighbour<D>(neighbours, i, [&](auto j) {
      const Vec3Of<Real> d = p.xyz() - gather(position, j).xyz();
      const Real t = kernel.distance_ratio2(d);
      const Real u = unit_part(Real(1.0f) - t);
      const Vec3Of<Real> apart = v.xyz() - gather(velocity, j).xyz();
      Real factor = u * u * dot(apart, d) / t;
      if constexpr (!uniform) factor *= viscosity_between(self, gather(viscosity, j));
      total += factor * d;
    });
    return scale * kernel.inverse_h2 * (uniform ? common_viscosity : 1.0f) * sum(total);
  }
};

/// The state of a solve.
struct Progress {
  double gamma, alpha;  ///< of the last iteration
  double limit;         ///< of γ
  uint32_t ended;       ///< 1 once the solve has converged
  uint32_t iterations;  ///< so far
  uint32_t number;      ///< of the solve, counted from the first one
  float next_alpha, next_beta;
};

struct Begin {
  View<Progress> progress;

  MENISCUS_HD void operator()(uint32_t) const { progress[0] = {0, 0, 0, 0, 0, progress[0].number + 1, 0, 0}; }
};

/// r = −h_t A v*, u = P⁻¹ r. P is the mass, plus what walls other than cloth add.
template <bool uniform>
struct Start {
  Forces<uniform> forces;
  View<const Vec4> velocity;
  View<Vec4> residual;  ///< u; w: P

  template <class D>
  MENISCUS_HD void run(uint32_t i) const {
    Vec3 force = forces.template between_pairs<D>(i, velocity);
    const Vec4 p = forces.position[i];
    const Vec3 v = velocity[i].xyz();
    float weight = 1 / p.w;
    const Walls& walls = forces.walls;
    walls.for_each(i, [&](uint32_t k, float a) {
      const Contact& c = walls.contacts.contacts[k];
      force += a * Walls::along(c, v - walls.velocity(k));
      if (c.body != pbd::on_cloth) weight += a;
    });
    if (D::leads()) residual[i] = pbd::with_w((-1 / weight) * force, weight);
  }
};

/// w = (M + h_t A) u.
template <bool uniform>
struct Multiply {
  Forces<uniform> forces;
  View<const Progress> progress;
  View<const Vec4> residual;
  View<Vec4> product;

  template <class D>
  MENISCUS_HD void run(uint32_t i) const {
    if (progress[0].ended) return;
    Vec3 force = forces.template between_pairs<D>(i, residual);
    const Vec4 p = forces.position[i];
    const Vec3 u = residual[i].xyz();
    const Walls& walls = forces.walls;
    walls.for_each(i, [&](uint32_t k, float a) {
      force += a * Walls::along(walls.contacts.contacts[k], u - walls.change(k));
    });
    if (D::leads()) product[i] = pbd::with_w((1 / p.w) * u + force, 0);
  }
};

struct Dots {
  double gamma = 0;  ///< r · u
  double delta = 0;  ///< w · u
};

struct AddDots {
  MENISCUS_HD Dots operator()(const Dots& a, const Dots& b) const {
    return {a.gamma + b.gamma, a.delta + b.delta};
  }
};

struct MeasureDots {
  View<const Progress> progress;
  View<const Vec4> residual, product;

  MENISCUS_HD Dots operator()(uint32_t i) const {
    if (progress[0].ended) return {};
    const Vec4 u = residual[i];
    return {double{u.w} * dot(u.xyz(), u.xyz()), double{dot(product[i].xyz(), u.xyz())}};
  }
};

/// Ends the solve, or chooses the next step. Chronopoulos & Gear 1989: both sums of an iteration in one.
struct Decide {
  View<const Dots> dots;
  View<Progress> progress;
  View<uint32_t> ended;  ///< the number of the solve that has ended, for the host
  double tolerance2;

  MENISCUS_HD void operator()(uint32_t) const {
    Progress& p = progress[0];
    if (p.ended) return;
    const Dots d = dots[0];
    if (p.iterations == 0) p.limit = tolerance2 * d.gamma;
    const double beta = p.iterations == 0 ? 0 : d.gamma / p.gamma;
    const double divisor = p.iterations == 0 ? d.delta : d.delta - beta * d.gamma / p.alpha;
    // What is not finite ends the solve as well: the step that finds it is taken back.
    if (!(d.gamma > p.limit) || !(divisor > 0)) {
      p.ended = 1;
      ended[0] = p.number;
      return;
    }
    p.gamma = d.gamma;
    p.alpha = d.gamma / divisor;
    p.next_alpha = static_cast<float>(p.alpha);
    p.next_beta = static_cast<float>(beta);
    ++p.iterations;
  }
};

struct Advance {
  View<const Progress> progress;
  View<const Vec4> product;
  View<Vec4> residual, direction, along_direction, change;

  MENISCUS_HD void operator()(uint32_t i) const {
    const Progress p = progress[0];
    if (p.ended) return;
    const bool first = p.iterations == 1;
    const Vec4 u = residual[i];
    const Vec3 none{0, 0, 0};
    const Vec3 d = u.xyz() + (first ? none : p.next_beta * direction[i].xyz());
    const Vec3 s = product[i].xyz() + (first ? none : p.next_beta * along_direction[i].xyz());
    direction[i] = pbd::with_w(d, 0);
    along_direction[i] = pbd::with_w(s, 0);
    change[i] = pbd::with_w((first ? none : change[i].xyz()) + p.next_alpha * d, 0);
    residual[i] = pbd::with_w(u.xyz() - (p.next_alpha / u.w) * s, u.w);
  }
};

/// Changes the velocities, and records in the contacts what walls have exerted. A residual is left. At walls
/// its impulse goes to the particle, so that the momentum of both is kept to rounding.
template <bool uniform>
struct Finish {
  Forces<uniform> forces;
  View<const Progress> progress;
  View<const Vec4> residual, change;
  View<Vec4> velocity;

  MENISCUS_HD void operator()(uint32_t i) const {
    const Progress p = progress[0];
    const Vec4 v = velocity[i];
    const Vec4 position = forces.position[i];
    const Vec3 solved = p.iterations > 0 ? v.xyz() + change[i].xyz() : v.xyz();
    const Walls& walls = forces.walls;
    walls.for_each(i, [&](uint32_t k, float a) {
      Contact& c = walls.contacts.contacts[k];
      c.density_push -= (walls.dt * a) * Walls::along(c, solved - walls.velocity(k));
    });
    const bool has_walls = walls.weights.count > 0;
    const Vec4 u = residual[i];
    const Vec3 rest = has_walls && p.ended ? (u.w * position.w) * u.xyz() : Vec3{0, 0, 0};
    velocity[i] = pbd::with_w(solved + rest, v.w);
  }
};

}  // namespace meniscus::fluid::viscosity_kernels
