// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of the density constraint for particles that touch a wall, as in density_kernels.h, with mirror
// ghosts.
#pragma once

#include "fluid/kernel/density_kernels.h"
#include "fluid/kernel/mirror_ghosts.h"
#include "fluid/kernel/tuning.h"
#include "pbd/contact_projection.h"

namespace meniscus::fluid::density_kernels {

/// The contribution to D of the bodies behind the mirrors. When a body moves by δ along the normal, each
/// mirror ghost recedes by 2δ. A body's inverse mass is split among its contacts, so that the bound on the
/// spectrum of D⁻¹A holds.
template <class Through>
MENISCUS_HD float give_of_bodies(const ContactView& contacts, const MirrorPlanes& mirrors, int n,
                                 const Through& through) {
  float give = 0;
  MENISCUS_UNROLL
  for (int k = 0; k < n; ++k) {
    if (k >= mirrors.count) break;
    const float e = 2 * through(k);
    give += contacts.contacts[mirrors.contact[k]].body_inverse_mass * e * e;
  }
  return give;
}

/// D includes the effect of each particle's motion on C through its mirror ghosts: when i approaches the
/// wall, so does its mirror ghost.
template <class D, int n, WallMotion motion, class K>
MENISCUS_HD Constraint constraint_with_mirrors(const K& kernel, View<const Vec4> position,
                                               const NeighbourView& neighbours, const ContactView& contacts,
                                               const MirrorPlanes& mirrors, uint32_t i) {
  using Real = typename D::Real;
  const Vec4 self = position[i];
  const Vec3 x = self.xyz();
  GhostSums<Real, n, false> sums;
  Real weight(0.0f), gradient2(0.0f);
  const auto term = [&](const Real& fraction, const Real& r2) {
    const Real t = Real(kernel.inverse_h2) * r2, inverse_root = inverse_sqrt(t);
    weight += fraction * K::weight_shape(t, inverse_root);
    return fraction * K::slope_shape(t, inverse_root) * inverse_root;
  };
  pbd::for_each_neighbour<D>(neighbours, i, [&](auto j) {
    const auto other = gather(position, j);
    const MirrorDistances<Real, n> distances(mirrors, other.xyz());
    const Vec3Of<Real> d = x - other.xyz();
    const Real r2 = dot(d, d) + Real(tiny_distance2);
    PairTerms<Real, n, false> terms;
    terms.total = term(Real(1.0f), r2);
    terms.add_ghosts(mirrors, distances, r2, term);
    sums.add(mirrors, distances, d, terms);
    const Vec3Of<Real> pull = terms.seen_by_other(mirrors, d);
    gradient2 += other.w * dot(pull, pull);
  });
  float self_weight = 0;
  const auto own = self_ghosts<n, false>(mirrors, [&](float fraction, float r2) {
    const float t = kernel.inverse_h2 * r2, inverse_root = inverse_sqrt(t);
    self_weight += fraction * K::weight_shape(t, inverse_root);
    return fraction * K::slope_shape(t, inverse_root) * inverse_root;
  });
  const float pull = kernel.peak_pull;  // a common factor of all terms except the weights
  float give = 0;
  if constexpr (motion == WallMotion::any) {
    give = give_of_bodies(contacts, mirrors, n,
                          [&](int k) { return pull * (sums.through(mirrors, k) + own.through(mirrors, k)); });
  }
  const Vec3 self_gradient = pull * own.vector(mirrors),
             gradient = pull * sums.vector(mirrors) + self_gradient;
  const Vec3 with_motion = gradient + self_gradient;
  return {kernel.peak_weight * (sum(weight) + self_weight + 1) - 1,
          self.w * dot(with_motion, with_motion) + pull * pull * sum(gradient2) + give, gradient};
}

template <class D, WallMotion motion, class K>
MENISCUS_HD Constraint density_constraint_at_walls(const K& kernel, View<const Vec4> position,
                                                   const NeighbourView& neighbours,
                                                   const ContactView& contacts, uint32_t i) {
  const MirrorPlanes mirrors = mirrors_at(contacts, i, position[i].xyz(), kernel.h);
  if (mirrors.count <= 1) {
    return constraint_with_mirrors<D, 1, motion>(kernel, position, neighbours, contacts, mirrors, i);
  }
  return constraint_with_mirrors<D, MirrorPlanes::most, motion>(kernel, position, neighbours, contacts,
                                                                mirrors, i);
}

template <class K, WallMotion motion, Grains grains>
struct AdvanceAtWalls {
  K kernel;
  NeighbourView neighbours;
  ContactView contacts;
  Advancing advancing;

  template <class D>
  MENISCUS_HD void run(uint32_t k) const {
    const uint32_t i = contacts.touching_particle(k);
    if (i == pbd::no_index) return;
    if (grains == Grains::present && advancing.passes_over(i)) return;
    const Constraint c =
        density_constraint_at_walls<D, motion>(kernel, advancing.position, neighbours, contacts, i);
    if (D::leads()) advancing.advance(i, advancing.own(i), c);  // loading it earlier would take registers
  }
};

/// If any wall moves, the contacts record all pushes of the mirror ghosts; else only the components through
/// the walls. Along a fixed wall the components have no effect, and would take registers.
template <class K, Repulsion repulsion, WallMotion motion>
struct CorrectAtWalls {
  static constexpr bool any_moving = motion == WallMotion::any;

  K kernel;
  PairPressure pair;
  View<const Vec4> staged;
  NeighbourView neighbours;
  pbd::ContactProjection walls;
  bool projects;  ///< also projects the particles' contacts

  template <class D>
  MENISCUS_HD void run(uint32_t k) const {
    const uint32_t i = walls.contacts.touching_particle(k);
    if (i == pbd::no_index) return;
    const MirrorPlanes mirrors = mirrors_at(walls.contacts, i, staged[i].xyz(), kernel.h);
    mirrors.count <= 1 ? correct<D, 1>(i, mirrors) : correct<D, MirrorPlanes::most>(i, mirrors);
  }

  template <class D, int n>
  MENISCUS_HD void correct(uint32_t i, const MirrorPlanes& mirrors) const {
    const Vec4 self = staged[i];
    const Vec3 total = push<D, n>(i, self, mirrors);
    if (!D::leads()) return;
    const Vec4 before = walls.accumulated_delta[i];
    const Vec3 step = before.w * total;
    Vec4 to = pbd::with_w(self.xyz() + step, before.w), accumulated_delta = pbd::shifted(before, step);
    if (projects) walls.hold(i, to, accumulated_delta);
    walls.position[i] = to;
    walls.accumulated_delta[i] = accumulated_delta;
  }

  /// The positional impulse on particle i, of which the walls get the opposite.
  template <class D, int n>
  MENISCUS_HD Vec3 push(uint32_t i, const Vec4& self, const MirrorPlanes& mirrors) const {
    using Real = typename D::Real;
    const Vec3 x = self.xyz();
    const Real pull(kernel.peak_pull);
    GhostSums<Real, n, any_moving> pushes;
    pbd::for_each_neighbour<D>(neighbours, i, [&](auto j) {
      const auto other = gather(staged, j);
      const MirrorDistances<Real, n> distances(mirrors, other.xyz());
      const Vec3Of<Real> d = x - other.xyz();
      const Real r2 = dot(d, d) + Real(tiny_distance2), multiplier = Real(self.w) + other.w;
      const auto term = [&](const Real& fraction, const Real& ghost_r2) {
        return pull * fraction *
               push_shape<K, repulsion>(pair, Real(kernel.inverse_h2) * ghost_r2, multiplier);
      };
      PairTerms<Real, n, any_moving> terms;
      terms.total = term(Real(1.0f), r2);
      terms.add_ghosts(mirrors, distances, r2, term);
      pushes.add(mirrors, distances, d, terms);
    });
    const auto own = self_ghosts<n, any_moving>(mirrors, [&](float fraction, float r2) {
      return kernel.peak_pull * fraction * push_shape<K, repulsion>(pair, kernel.inverse_h2 * r2, 2 * self.w);
    });
    const auto others = pushes.in_one(mirrors);
    if (D::leads()) note_pushes(mirrors, others, own);
    return others.vector(mirrors) + own.vector(mirrors);
  }

  /// The solids receive the opposite of their mirror ghosts' push on a particle. Each receives that of its
  /// own mirror. The first also receives the small remainder of mirror ghosts of mirror ghosts.
  template <int n>
  MENISCUS_HD void note_pushes(const MirrorPlanes& mirrors, const GhostSums<float, n, any_moving>& others,
                               const GhostSums<float, n, any_moving>& own) const {
    Vec3 rest = others.vector(mirrors) - sum(others.along) + own.vector(mirrors) - sum(own.along);
    MENISCUS_UNROLL
    for (int k = n - 1; k >= 0; --k) {
      if (k >= mirrors.count) continue;
      Vec3 push = (others.through(mirrors, k) + own.through(mirrors, k)) * mirrors.normal[k];
      if constexpr (any_moving) {
        push += others.along_mirror(mirrors, k) + own.along_mirror(mirrors, k);
        rest = rest - push;
        if (k == 0) push += rest;
      }
      walls.contacts.contacts[mirrors.contact[k]].density_push += push;
    }
  }
};

template <class K>
struct Measure {
  K kernel;
  View<const Vec4> position;
  NeighbourView neighbours;
  ContactView contacts;
  View<const uint32_t> slot;
  View<const pbd::Phase> phase;
  View<float> error;  ///< C; of grains 0
  View<float> full;   ///< 1 where the support is full, else 0

  template <class D>
  MENISCUS_HD void run(uint32_t i) const {
    const Constraint c =
        density_constraint_at_walls<D, WallMotion::none>(kernel, position, neighbours, contacts, i);
    if (!D::leads()) return;
    if (pbd::is_grain(phase[i])) {
      error[slot[i]] = full[slot[i]] = 0;
      return;
    }
    error[slot[i]] = c.value;
    const float threshold2 =
        kernel_tuning::full_gradient2 / cbrtf(kernel.particle_volume * kernel.particle_volume);
    full[slot[i]] =
        dot(c.gradient, c.gradient) < threshold2 && c.value > kernel_tuning::full_density ? 1.0f : 0.0f;
  }
};

}  // namespace meniscus::fluid::density_kernels
