// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of crowd.h.
#pragma once

#include "fluid/density/tuning.h"
#include "fluid/kernel/density_wall_kernels.h"
#include "pbd/math/random.h"

namespace meniscus::fluid::crowd_kernels {

using density_kernels::Constraint;
using pbd::ContactView;
using pbd::NeighbourView;
using pbd::Vec3Of;
using pbd::Vec4;
using pbd::View;

/// |e| over the kernel's greatest, as crowds use it: that of spiky, whatever the kernel. The slopes of the
/// others vanish at r = 0, where a crowd must part.
template <class R>
MENISCUS_HD R parting_shape(const R& t, const R& inverse_root) {
  return ShapedKernel<SmoothingKernel::poly6_spiky>::slope_shape(t, inverse_root);
}

/// What a particle brings to its pairs. Every particle has a bound.
struct Parting {
  float multiplier;  ///< kg·m², 0 outside of the crowd
  float bound;       ///< kg·m²: the part of each pair, so that all together move it by at most the limit
};
/// As a vector, so that eight are gathered at once.
MENISCUS_HD inline Vec4 packed(const Parting& p) {
  return {p.multiplier, p.bound, 0, 0};
}
MENISCUS_HD inline Parting unpacked(const Vec4& v) {
  return {v.x, v.y};
}

/// What a particle of the crowd keeps from one substep to the next.
struct alignas(8) Member {
  float kept;  ///< the part of C that it may keep, above 0; 0 outside of the crowd; below 0: just placed
  float multiplier;  ///< kg·m², of the last round

  MENISCUS_HD static Member just_placed() { return {-1, 0}; }
  MENISCUS_HD bool is_just_placed() const { return kept < 0; }
};

struct MarkPlaced {
  uint32_t first;
  View<Member> member;

  MENISCUS_HD void operator()(uint32_t k) const { member[first + k] = Member::just_placed(); }
};

struct Begin {
  View<const Vec4> previous;
  View<const Member> member;
  View<Vec4> position;
  View<float> in_crowd;
  View<uint32_t> left;

  MENISCUS_HD void operator()(uint32_t i) const {
    position[i] = previous[i];
    in_crowd[i] = member[i].kept > 0 ? 1.0f : 0.0f;
    if (i == 0) left[0] = 0;
  }
};

/// The error of a particle: C, or how near others are to the very same point, which C does not see where
/// these are few.
struct Error {
  Constraint constraint;
  float nearness;
  float slope;     ///< Σ |e| over the peak
  bool is_beside;  ///< whether any neighbour belongs to the crowd

  MENISCUS_HD float value() const { return pbd::max(constraint.value, nearness); }
  MENISCUS_HD bool joins(bool is_just_placed) const {
    return is_beside
               ? value() > crowd_tuning::joins
               : is_just_placed && (constraint.value > crowd_tuning::dense || nearness > crowd_tuning::near);
  }
};

template <class D, class K>
MENISCUS_HD Error error_at(const K& kernel, float near, View<const Vec4> position, View<const float> in_crowd,
                           const NeighbourView& neighbours, const ContactView& contacts, uint32_t i) {
  using Real = typename D::Real;
  const Vec3 x = position[i].xyz();
  Real nearness(0.0f), slope(0.0f), beside(0.0f);
  pbd::for_each_neighbour<D>(neighbours, i, [&](auto j) {
    const Real t = kernel.distance_ratio2(x - gather(position, j).xyz());
    const Real inverse_root = inverse_sqrt(t);
    nearness += unit_part(Real(1.0f) - Real(kernel.h / near) * (t * inverse_root));
    slope += parting_shape(t, inverse_root);
    beside += gather(in_crowd, j);
  });
  const Constraint c = density_kernels::density_constraint_at_walls<D, density_kernels::WallMotion::none>(
      kernel, position, neighbours, contacts, i);
  return {c, sum(nearness), sum(slope), sum(beside) > 0};
}

/// Decides who belongs to the crowd, and by what multiplier it parts.
template <class K>
struct Survey {
  K kernel;
  float near;  ///< m
  float momentum, step;
  float limit;  ///< m
  View<const Vec4> position;
  View<const pbd::Phase> phase;
  NeighbourView neighbours;
  ContactView contacts;
  View<const float> in_crowd;
  View<float> next_in_crowd;
  View<Member> member;
  View<Vec4> parting;  ///< packed

  template <class D>
  MENISCUS_HD void run(uint32_t i) const {
    const Error error = error_at<D>(kernel, near, position, in_crowd, neighbours, contacts, i);
    if (!D::leads()) return;
    const bool is_in =
        !pbd::is_grain(phase[i]) && (in_crowd[i] > 0 || error.joins(member[i].is_just_placed()));
    const float denominator = pbd::max(error.constraint.denominator, 1e-30f);
    const float bound = limit / pbd::max(position[i].w * kernel.greatest_slope * error.slope, 1e-30f);
    const float multiplier = is_in && error.value() > 0
                                 ? momentum * member[i].multiplier + step * error.value() / denominator
                                 : 0.0f;
    next_in_crowd[i] = is_in ? 1.0f : 0.0f;
    member[i].multiplier = pbd::min(multiplier, bound);
    if (is_in && !(member[i].kept > 0)) member[i].kept = pbd::most_finite;
    parting[i] = packed({member[i].multiplier, bound});
  }
};

/// A direction for a pair at one point: the same from either end but for its sign.
MENISCUS_HD inline Vec3 direction_of(uint32_t self, uint32_t other) {
  const bool first = self < other;
  const Vec3 r = pbd::random_numbers(first ? self : other, first ? other : self, 0);
  const float up = 2 * r.x - 1, around = 6.2831853f * r.y;
  const float out = sqrtf(pbd::max(1 - up * up, 0.0f));
  return (first ? 1.0f : -1.0f) * Vec3{out * cosf(around), out * sinf(around), up};
}

/// Parts the pairs of a crowd. It moves positions and gives no speed.
struct Part {
  Kernel kernel;
  View<const Vec4> position;
  View<const Vec4> parting;  ///< packed
  View<const uint32_t> number;
  NeighbourView neighbours;
  ContactView contacts;
  View<const Vec4> previous;
  View<Vec4> next_position;

  template <class D>
  MENISCUS_HD void run(uint32_t i) const {
    using Real = typename D::Real;
    const Vec4 self = position[i];
    const Parting own = unpacked(parting[i]);
    Vec3Of<Real> push{Real(0.0f), Real(0.0f), Real(0.0f)};
    Real coincident(0.0f);
    pbd::for_each_neighbour<D>(neighbours, i, [&](auto j) {
      const Vec3Of<Real> d = self.xyz() - gather(position, j).xyz();
      const auto other = gather(parting, j);
      const Real t = kernel.distance_ratio2(d), r2 = dot(d, d);
      const Real wanted = Real(own.multiplier) + other.x;
      const Real bound = select_less(other.y, Real(own.bound), other.y, Real(own.bound));
      const Real multiplier = select_less(wanted, bound, wanted, bound);
      const Real shape = parting_shape(t, inverse_sqrt(t));
      // By the true distance: the kernel's offset would leave a pair that is almost at one point together.
      const Real over = select_less(r2, Real(least_r2()), Real(0.0f), inverse_sqrt(r2 + Real(1e-36f)));
      coincident += select_less(r2, Real(least_r2()), Real(1.0f), Real(0.0f));
      push += (multiplier * shape * over) * d;
    });
    Vec3 total = sum(push);
    const bool any_coincident = sum(coincident) > 0;
    if (!D::leads()) return;
    if (any_coincident) total += push_of_coincident(i, self, own);
    // What is not pushed keeps its bits, whichever way a device rounds in `outside`.
    const bool is_pushed = dot(total, total) > 0;
    const Vec3 x = self.xyz() + (self.w * kernel.greatest_slope) * total;
    next_position[i] = is_pushed ? pbd::with_w(outside(i, x), self.w) : self;
  }

  /// x, but no deeper in solids than the particle was. Pushed in, it would be thrown out again.
  MENISCUS_HD Vec3 outside(uint32_t i, Vec3 x) const {
    for (uint32_t k = contacts.start[i]; k < contacts.start[i + 1]; ++k) {
      const pbd::Contact& c = contacts.contacts[k];
      const float least = pbd::min(c.radius, plane_distance(c, previous[i].xyz()));
      x += pbd::max(least - plane_distance(c, x), 0.0f) * c.normal;
    }
    return x;
  }

  MENISCUS_HD static constexpr float least_r2() { return 1e-30f; }

  MENISCUS_HD Vec3 push_of_coincident(uint32_t i, const Vec4& self, const Parting& own) const {
    Vec3 push{0, 0, 0};
    for (uint32_t k = 0; k < neighbours.size(i); ++k) {
      const uint32_t j = neighbours.at(i, k);
      const Vec3 d = self.xyz() - position[j].xyz();
      if (!(dot(d, d) < least_r2()) || j == neighbours.sentinel) continue;
      const Parting other = unpacked(parting[j]);
      const float multiplier = pbd::min(own.multiplier + other.multiplier, pbd::min(own.bound, other.bound));
      push += multiplier * direction_of(number[i], number[j]);
    }
    return push;
  }
};

/// Moves the particles, and records the compression that the crowd still has.
template <class K>
struct Finish {
  K kernel;
  float near;       ///< m
  float recovered;  ///< the part of a small compression that is no longer kept
  View<const Vec4> previous, parted;
  NeighbourView neighbours;
  ContactView contacts;
  View<const float> in_crowd;
  View<Vec4> position;
  View<Member> member;
  View<float> allowed;
  View<uint32_t> left;

  template <class D>
  MENISCUS_HD void run(uint32_t i) const {
    const Error error = error_at<D>(kernel, near, parted, in_crowd, neighbours, contacts, i);
    if (!D::leads()) return;
    const Vec3 shift = parted[i].xyz() - previous[i].xyz();
    if (dot(shift, shift) > 0) position[i] = pbd::shifted(position[i], shift);
    const float before = in_crowd[i] > 0 ? member[i].kept : 0.0f;
    const float due = before - recovered * pbd::min(before, 1.0f);
    const float present = (1 + crowd_tuning::rounding) * pbd::max(error.constraint.value, 0.0f);
    const float kept = pbd::min(due, present);
    allowed[i] = kept;
    if (pbd::max(kept, in_crowd[i] * error.nearness) < crowd_tuning::parted) {
      member[i] = {0, 0};
    } else {
      member[i].kept = pbd::max(kept, 1e-30f);
      pbd::atomic_add(left[0], 1);
    }
  }
};

}  // namespace meniscus::fluid::crowd_kernels
