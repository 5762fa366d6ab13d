// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels that the baselines share: C of each particle, and the pushes of multipliers. Kernels whose
// names end in AtWalls are for particles with contacts, and add mirror ghosts; the others pass these by.
#pragma once

#include "fluid/kernel/density_wall_kernels.h"
#include "pbd/substep.h"

namespace meniscus::fluid::baseline_kernels {

using density_kernels::CorrectAtWalls;
using density_kernels::Multiplier;
using density_kernels::PairPressure;
using density_kernels::Repulsion;
using density_kernels::WallMotion;
using pbd::ContactView;
using pbd::NeighbourView;
using pbd::Vec3Of;
using pbd::Vec4;
using pbd::View;

/// The baselines have this pair of kernels alone.
using BaselineKernel = ShapedKernel<SmoothingKernel::poly6_spiky>;

/// C = Σ V W − 1.
struct Compress {
  BaselineKernel kernel;
  View<const Vec4> position;
  NeighbourView neighbours;
  View<const uint32_t> contact_start;
  View<float> compression;

  template <class D>
  MENISCUS_HD void run(uint32_t i) const {
    if (contact_start[i] != contact_start[i + 1]) return;
    using Real = typename D::Real;
    const Vec3 x = position[i].xyz();
    Real weight(0.0f);
    pbd::for_each_neighbour<D>(neighbours, i, [&](auto j) {
      const Vec3Of<Real> d = x - gather(position, j).xyz();
      weight += BaselineKernel::weight_shape(kernel.distance_ratio2(d));
    });
    const float c = kernel.peak_weight * (sum(weight) + 1) - 1;
    if (D::leads()) compression[i] = c;
  }
};

struct CompressAtWalls {
  BaselineKernel kernel;
  View<const Vec4> position;
  NeighbourView neighbours;
  ContactView contacts;
  View<float> compression;

  template <class D>
  MENISCUS_HD void run(uint32_t k) const {
    const uint32_t i = contacts.touching_particle(k);
    if (i == pbd::no_index) return;
    const Vec3 x = position[i].xyz();
    const MirrorPlanes mirrors = mirrors_at(contacts, i, x, kernel.h);
    const float weight =
        mirrors.count <= 1 ? weight_at<D, 1>(i, x, mirrors) : weight_at<D, MirrorPlanes::most>(i, x, mirrors);
    if (D::leads()) compression[i] = kernel.peak_weight * weight - 1;
  }

  template <class D, int n>
  MENISCUS_HD float weight_at(uint32_t i, Vec3 x, const MirrorPlanes& mirrors) const {
    using Real = typename D::Real;
    Real weight(0.0f);
    const auto add = [&](const Real& fraction, const Real& r2) {
      weight += fraction * BaselineKernel::weight_shape(Real(kernel.inverse_h2) * r2);
      return Real(0.0f);
    };
    pbd::for_each_neighbour<D>(neighbours, i, [&](auto j) {
      const auto other = gather(position, j).xyz();
      const Vec3Of<Real> d = x - other;
      const Real r2 = dot(d, d) + Real(tiny_distance2);
      add(Real(1.0f), r2);
      PairTerms<Real, n, false>().add_ghosts(mirrors, MirrorDistances<Real, n>(mirrors, other), r2, add);
    });
    float own = 1;
    self_ghosts<n, false>(mirrors, [&](float fraction, float r2) {
      own += fraction * BaselineKernel::weight_shape(kernel.inverse_h2 * r2);
      return 0.0f;
    });
    return sum(weight) + own;
  }
};

/// ω/D, the change of Λ for one of C; D is that of the density constraint. 0 for a particle alone.
struct FindSteps {
  BaselineKernel kernel;
  View<const Vec4> position;
  NeighbourView neighbours;
  View<const uint32_t> contact_start;
  float relaxation;
  View<float> step;

  template <class D>
  MENISCUS_HD void run(uint32_t i) const {
    if (contact_start[i] != contact_start[i + 1]) return;
    const float d = density_kernels::density_constraint<D>(kernel, position, neighbours, i).denominator;
    if (D::leads()) step[i] = d > 0 ? relaxation / d : 0.0f;
  }
};

template <WallMotion motion>
struct FindStepsAtWalls {
  BaselineKernel kernel;
  View<const Vec4> position;
  NeighbourView neighbours;
  ContactView contacts;
  float relaxation;
  View<float> step;

  template <class D>
  MENISCUS_HD void run(uint32_t k) const {
    const uint32_t i = contacts.touching_particle(k);
    if (i == pbd::no_index) return;
    const float d =
        density_kernels::density_constraint_at_walls<D, motion>(kernel, position, neighbours, contacts, i)
            .denominator;
    if (D::leads()) step[i] = d > 0 ? relaxation / d : 0.0f;
  }
};

/// Fixes the positions at which gradients are taken from now on, and stages no multiplier.
struct Stage {
  View<const Vec4> position;
  View<Vec4> staged;

  MENISCUS_HD void operator()(uint32_t i) const { staged[i] = pbd::with_w(position[i].xyz(), 0); }
};

/// One step of a Jacobi iteration: Λ' = max(0, Λ + step · C). It stages the change.
template <float Multiplier::*part>
struct Relax {
  View<const float> compression, step;
  View<Multiplier> multiplier;
  View<Vec4> staged;

  MENISCUS_HD void operator()(uint32_t i) const {
    float& value = multiplier[i].*part;
    const float old = value, next = pbd::max(0.0f, old + step[i] * compression[i]);
    value = next;
    staged[i].w = next - old;
  }
};

/// Where pushes go: to the positions of particles,
struct ToPositions {
  static constexpr bool walls_recede = false;
  View<Vec4> position, accumulated_delta;

  MENISCUS_HD void add(uint32_t i, Vec3 push) const {
    const Vec4 before = accumulated_delta[i];
    const Vec3 step = before.w * push;
    position[i] = pbd::with_w(position[i].xyz() + step, before.w);
    accumulated_delta[i] = pbd::shifted(before, step);
  }
};

/// or to their velocities. With `recede` bodies give way at once, each contact by its fraction of the body;
/// else they do so when the contacts are projected.
template <bool recede>
struct ToVelocities {
  static constexpr bool walls_recede = recede;
  View<const Vec4> accumulated_delta;  ///< w: inverse mass
  View<Vec4> velocity;
  float inverse_dt;

  MENISCUS_HD void add(uint32_t i, Vec3 push) const {
    velocity[i] = pbd::shifted(velocity[i], (inverse_dt * accumulated_delta[i].w) * push);
  }
};

/// Pushes each particle by the staged multipliers of itself and its neighbours: Σ (Λ_i + Λ_j) e_ij.
template <class Target>
struct Push {
  BaselineKernel kernel;
  View<const Vec4> staged;
  NeighbourView neighbours;
  View<const uint32_t> contact_start;
  Target target;

  template <class D>
  MENISCUS_HD void run(uint32_t i) const {
    if (contact_start[i] != contact_start[i + 1]) return;
    using Real = typename D::Real;
    const Vec4 self = staged[i];
    Vec3Of<Real> push{Real(0.0f), Real(0.0f), Real(0.0f)};
    pbd::for_each_neighbour<D>(neighbours, i, [&](auto j) {
      const auto other = gather(staged, j);
      const Vec3Of<Real> d = self.xyz() - other.xyz();
      push += density_kernels::push_shape<BaselineKernel, Repulsion::off, Real>({}, kernel.distance_ratio2(d),
                                                                                Real(self.w) + other.w) *
              d;
    });
    const Vec3 total = sum(push);
    if (D::leads()) target.add(i, kernel.peak_pull * total);
  }
};

template <WallMotion motion, class Target>
struct PushAtWalls {
  CorrectAtWalls<BaselineKernel, Repulsion::off, motion> correct;
  Target target;

  template <class D>
  MENISCUS_HD void run(uint32_t k) const {
    const ContactView& contacts = correct.walls.contacts;
    const uint32_t i = contacts.touching_particle(k);
    if (i == pbd::no_index) return;
    const Vec4 self = correct.staged[i];
    const MirrorPlanes mirrors = mirrors_at(contacts, i, self.xyz(), correct.kernel.h);
    float before[MirrorPlanes::most] = {};
    for_each_receding(mirrors, [&](int m, pbd::Contact& c) { before[m] = dot(c.density_push, c.normal); });
    const Vec3 push = mirrors.count <= 1 ? correct.template push<D, 1>(i, self, mirrors)
                                         : correct.template push<D, MirrorPlanes::most>(i, self, mirrors);
    if (!D::leads()) return;
    target.add(i, push);
    for_each_receding(mirrors, [&](int m, pbd::Contact& c) {
      const float pushed = dot(c.density_push, c.normal) - before[m];
      c.surface_motion -= (c.body_inverse_mass * pushed) * c.normal;
    });
  }

  template <class Visit>
  MENISCUS_HD void for_each_receding(const MirrorPlanes& mirrors, const Visit& visit) const {
    if constexpr (Target::walls_recede && motion == WallMotion::any) {
      MENISCUS_UNROLL
      for (int m = 0; m < MirrorPlanes::most; ++m) {
        if (m < mirrors.count) visit(m, correct.walls.contacts.contacts[mirrors.contact[m]]);
      }
    }
  }
};

}  // namespace meniscus::fluid::baseline_kernels
