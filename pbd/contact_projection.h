// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The projection of contacts within an iteration of the solve. The formulas are in
// collision/contact/contact_set.h.
#pragma once

#include "pbd/contacts.h"
#include "pbd/device/scalar.h"
#include "pbd/substep.h"

namespace meniscus::pbd {

/// The positional impulse, kg·m, that closes a gap in m between sides whose inverse masses add up to w. It is
/// 0 where w = 0: between what is held and what is immovable no impulse changes anything.
template <class Gap>
MENISCUS_HD inline Gap closing_impulse(const Gap& gap, float w) {
  return w > 0 ? gap / w : Gap{};
}

/// The increment of the normal multiplier, kg·m, for a particle at x.
MENISCUS_HD inline Vec3 push_out(Contact& c, Vec3 x, float w, float radius) {
  const float old = c.normal_multiplier, distance = plane_distance(c, x);
  c.normal_multiplier =
      max(least_push(c, distance), old + closing_impulse(radius - distance, w + c.body_inverse_mass));
  return (c.normal_multiplier - old) * c.normal;
}

/// The increment of the friction, kg·m, for a particle with this displacement.
MENISCUS_HD inline Vec3 apply_friction(Contact& c, Vec3 displacement, float w) {
  const Vec3 old = c.tangent_multiplier;
  c.tangent_multiplier =
      shortened_to(old - closing_impulse(slip(c, displacement), w + c.body_inverse_mass), most_friction(c));
  return c.tangent_multiplier - old;
}

struct ContactProjection {
  View<Vec4> position, accumulated_delta;
  View<const Vec4> previous;
  View<const uint32_t> number;
  ContactView contacts;

  /// Projects the contacts of particle i, which has some.
  MENISCUS_HD void project(uint32_t i) const {
    Vec4 p = position[i], displacement = accumulated_delta[i];
    hold(i, p, displacement);
    position[i] = p;
    accumulated_delta[i] = displacement;
  }
  /// The same for particle i at p, with this displacement. A held particle stays, and records what it
  /// withstands.
  MENISCUS_HD void hold(uint32_t i, Vec4& p, Vec4& displacement) const {
    const uint32_t begin = contacts.start[i], end = contacts.start[i + 1];
    const float tighter = pbd::fraction_of_radius(number[i]);
    const Vec3 x = p.xyz(), start = previous[i].xyz();
    const float recorded = recorded_part(p.w), moves = p.w > 0 ? 1.0f : 0.0f;
    Vec3 step{0, 0, 0};  // of the accumulated delta
    const auto at = [&] { return x + moves * step; };
    // A contact is loaded as a whole, and the next one before this one is written.
    Contact next = contacts.contacts[begin];
    for (uint32_t k = begin; k < end; ++k) {
      Contact c = next;
      next = contacts.contacts[k + 1 < end ? k + 1 : k];
      if (is_attachment(c)) continue;
      step += recorded * push_out(c, at(), p.w, tighter * c.radius);
      if (c.friction > 0) step += recorded * apply_friction(c, at() - start, p.w);
      Contact& to = contacts.contacts[k];
      to.normal_multiplier = c.normal_multiplier;
      to.tangent_multiplier = c.tangent_multiplier;
    }
    p = pbd::with_w(at(), p.w);
    displacement = shifted(displacement, step);
  }
};

template <class D>
ContactProjection contact_projection(const Substep<D>& substep) {
  const ParticleView& p = substep.particles;
  return {p.position, p.accumulated_delta, p.previous, p.number, substep.contacts};
}

}  // namespace meniscus::pbd
