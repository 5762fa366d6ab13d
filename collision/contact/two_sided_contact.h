// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Two-sided contact: a vertex of cloth between a body and the surface that supports it, such as a crate on a
// carpet. Solved in turn, two such contacts transfer next to no load, because a light vertex seems to yield
// to either. So both are solved at once.
#pragma once

#include "collision/contact/tuning.h"
#include "pbd/contact_projection.h"

namespace meniscus::collision {

/// Two contacts of a vertex that press on it from opposite sides.
struct OpposedPair {
  uint32_t a = pbd::no_index, b = pbd::no_index;

  MENISCUS_HD bool is_there() const { return a != pbd::no_index; }
  MENISCUS_HD bool has(uint32_t k) const { return k == a || k == b; }
};

/// Whether the contact acts on a vertex at x, or is about to.
MENISCUS_HD inline bool contact_presses(const pbd::Contact& c, Vec3 x) {
  if (is_attachment(c) || c.solid == pbd::no_index) return false;
  const float load = c.normal_multiplier + dot(c.density_push, c.normal);
  return load > 0 || !(c.tangent_multiplier == Vec3{0, 0, 0}) || plane_distance(c, x) < c.radius;
}

/// Of contacts first to end − 1, the two whose normals are most nearly opposite. At least one of their
/// surfaces must be movable.
MENISCUS_HD inline OpposedPair find_opposed(pbd::View<const pbd::Contact> contacts, uint32_t first,
                                            uint32_t end, Vec3 x) {
  OpposedPair pair;
  float least = shape_tuning::opposed;
  for (uint32_t a = first; a + 1 < end; ++a) {
    if (!contact_presses(contacts[a], x)) continue;
    for (uint32_t b = a + 1; b < end; ++b) {
      const float facing = dot(contacts[a].normal, contacts[b].normal);
      const float inverse_mass = contacts[a].body_inverse_mass + contacts[b].body_inverse_mass;
      if (!(facing < least) || !(inverse_mass > 0) || !contact_presses(contacts[b], x)) continue;
      least = facing;
      pair = {a, b};
    }
  }
  return pair;
}

/// Both contacts, taken as parallel planes. If they are not quite parallel, the load on them would squeeze a
/// light vertex out as far as the planes reach. A real one does not slip before friction yields.
struct TwoSidedContact {
  pbd::Contact &a, &b;
  float w;    ///< 1/kg, of the vertex
  Vec3 axis;  ///< unit, from b's surface to the vertex, and on to a's

  /// Solves both normal constraints for a vertex at x; returns the impulse on it, kg·m.
  MENISCUS_HD Vec3 push_apart(Vec3 x, float tighter) const {
    const float lack_a = tighter * a.radius - plane_distance(a, x);
    const float lack_b = tighter * b.radius - plane_distance(b, x);
    const float least_a = least_push(a, plane_distance(a, x)) - a.normal_multiplier;
    const float least_b = least_push(b, plane_distance(b, x)) - b.normal_multiplier;
    float more_a = ((w + inverse_mass_b()) * lack_a + w * lack_b) / determinant();
    float more_b = ((w + inverse_mass_a()) * lack_b + w * lack_a) / determinant();
    const auto solve_a = [&] { more_a = pbd::max(least_a, (lack_a + w * more_b) / (w + inverse_mass_a())); };
    const auto solve_b = [&] { more_b = pbd::max(least_b, (lack_b + w * more_a) / (w + inverse_mass_b())); };
    if (more_a < least_a) {
      more_a = least_a;
      solve_b();
      solve_a();
    } else if (more_b < least_b) {
      more_b = least_b;
      solve_a();
      solve_b();
    }
    add(a, more_a, -1.0f * axis);
    add(b, more_b, axis);
    return (more_b - more_a) * axis;
  }

  /// Solves friction on both contacts for a vertex with this displacement; returns the impulse on it, kg·m.
  /// The contact with the lower bound slips, and the vertex follows the other.
  MENISCUS_HD Vec3 apply_friction(Vec3 displacement) const {
    const Vec3 old_a = a.tangent_multiplier, old_b = b.tangent_multiplier;
    const Vec3 slip_a = slip(a, displacement), slip_b = slip(b, displacement);
    const Vec3 wanted_a = old_a - (1 / determinant()) * ((w + inverse_mass_b()) * slip_a - w * slip_b);
    const Vec3 wanted_b = old_b - (1 / determinant()) * ((w + inverse_mass_a()) * slip_b - w * slip_a);
    const float most_a = most_friction(a), most_b = most_friction(b);
    const bool holds_a = length(wanted_a) <= most_a, holds_b = length(wanted_b) <= most_b;
    const auto moved = [&] { return w * (a.tangent_multiplier - old_a + b.tangent_multiplier - old_b); };
    if (holds_a && holds_b) {
      a.tangent_multiplier = wanted_a;
      b.tangent_multiplier = wanted_b;
    } else {
      const bool is_a = !holds_a && (holds_b || most_a <= most_b);
      pbd::Contact &slipping = is_a ? a : b, &holding = is_a ? b : a;
      slipping.tangent_multiplier = shortened_to(is_a ? wanted_a : wanted_b, is_a ? most_a : most_b);
      apply_friction(holding, displacement + moved());
      apply_friction(slipping, displacement + moved());
    }
    return moved() / w;
  }

  /// Transfers friction between the two surfaces through a vertex that sticks to one of them and is not
  /// moved. Each contact gets the opposite of what the other gets.
  MENISCUS_HD void transfer_friction(Vec3 displacement) const {
    const Vec3 slip_a = slip(a, displacement), slip_b = slip(b, displacement);
    const Vec3 more = (1 / (inverse_mass_a() + inverse_mass_b())) * (slip_b - slip_a);
    const float fraction = pbd::min(fraction_within(a.tangent_multiplier, more, most_friction(a)),
                                    fraction_within(b.tangent_multiplier, -1.0f * more, most_friction(b)));
    const float least = pbd::min(length(slip_a), length(slip_b)),
                most = pbd::max(length(slip_a), length(slip_b));
    if (fraction < 1 && least > shape_tuning::sticking * most) return;
    a.tangent_multiplier += fraction * more;
    b.tangent_multiplier -= fraction * more;
  }

 private:
  MENISCUS_HD float inverse_mass_a() const { return a.body_inverse_mass; }
  MENISCUS_HD float inverse_mass_b() const { return b.body_inverse_mass; }
  /// Of the matrix {w + w_a, −w; −w, w + w_b}, with the inverse masses w_a and w_b of the surfaces.
  MENISCUS_HD float determinant() const {
    return w * (inverse_mass_a() + inverse_mass_b()) + inverse_mass_a() * inverse_mass_b();
  }

  /// The largest fraction, up to 1, with |old + fraction · more| ≤ most; 0 where there is none.
  MENISCUS_HD static float fraction_within(Vec3 old, Vec3 more, float most) {
    if (length(old + more) <= most) return 1;
    const float room2 = most * most - dot(old, old);
    if (!(room2 > 0)) return 0;
    const float along = dot(old, more), size2 = dot(more, more);
    return (sqrtf(along * along + size2 * room2) - along) / size2;
  }

  MENISCUS_HD static void add(pbd::Contact& c, float push, Vec3 along) {
    const float normal = push * dot(along, c.normal);
    c.normal_multiplier += normal;
    c.density_push += push * along - normal * c.normal;
  }
  MENISCUS_HD Vec3 slip(const pbd::Contact& c, Vec3 displacement) const {
    const Vec3 on_surface = displacement - c.surface_motion;
    return on_surface - dot(on_surface, axis) * axis;
  }
  /// Friction of one contact alone.
  MENISCUS_HD void apply_friction(pbd::Contact& c, Vec3 displacement) const {
    const Vec3 wanted = c.tangent_multiplier - slip(c, displacement) / (w + c.body_inverse_mass);
    c.tangent_multiplier = shortened_to(wanted, most_friction(c));
  }
};

MENISCUS_HD inline TwoSidedContact two_sided_between(pbd::Contact& a, pbd::Contact& b, float w) {
  const Vec3 across = b.normal - a.normal;
  return {a, b, w, across / length(across)};
}

/// Projects contacts where bodies may press on cloth, ropes and points of faces.
struct TwoSidedContacts {
  pbd::ContactProjection all;
  pbd::View<const pbd::Vec4> effective_mass;  ///< see Substep::effective_mass
  uint32_t sorted;                            ///< see ParticleView

  /// Projects particle i, which has contacts. Vertices that are pressed against bodies have had their
  /// friction before the chain solve.
  MENISCUS_HD void project(uint32_t i) const {
    const uint32_t n = i - sorted;
    if (i < sorted || effective_mass.count == 0)
      all.project(i);
    else if (n < effective_mass.count && effective_mass[n].w > 0)
      push_out(i);
    else
      push_out_with_friction(i);
  }

  /// Friction alone.
  MENISCUS_HD void apply_friction(uint32_t i) const {
    const Vec3 start = all.previous[i].xyz();
    solve(
        i, [&](Contact& c, Vec3 x, float w) { return pbd::apply_friction(c, x - start, w); },
        [&](const TwoSidedContact& both_sides, Vec3 x) { return both_sides.apply_friction(x - start); });
  }

 private:
  using Contact = pbd::Contact;

  MENISCUS_HD void push_out(uint32_t i) const {
    const float tighter = pbd::fraction_of_radius(all.number[i]);
    const Vec3 start = all.previous[i].xyz();
    solve(
        i, [&](Contact& c, Vec3 x, float w) { return pbd::push_out(c, x, w, tighter * c.radius); },
        [&](const TwoSidedContact& both_sides, Vec3 x) {
          const Vec3 push = both_sides.push_apart(x, tighter);
          both_sides.transfer_friction(x + both_sides.w * push - start);
          return push;
        });
  }
  MENISCUS_HD void push_out_with_friction(uint32_t i) const {
    const float tighter = pbd::fraction_of_radius(all.number[i]);
    const Vec3 start = all.previous[i].xyz();
    solve(
        i,
        [&](Contact& c, Vec3 x, float w) {
          const Vec3 push = pbd::push_out(c, x, w, tighter * c.radius);
          return push + pbd::apply_friction(c, x + w * push - start, w);
        },
        [&](const TwoSidedContact& both_sides, Vec3 x) {
          const Vec3 push = both_sides.push_apart(x, tighter);
          return push + both_sides.apply_friction(x + both_sides.w * push - start);
        });
  }

  /// Solves the two-sided pair last, because it must yield to all other contacts. Through a held particle two
  /// contacts exert nothing on each other, so they are no pair.
  template <class One, class Pair>
  MENISCUS_HD void solve(uint32_t i, const One& one, const Pair& both) const {
    const pbd::Vec4 p = all.position[i];
    const uint32_t begin = all.contacts.start[i], end = all.contacts.start[i + 1];
    const pbd::View<Contact> contacts = all.contacts.contacts;
    const Vec3 x = p.xyz();
    const float recorded = pbd::recorded_part(p.w), moves = p.w > 0 ? 1.0f : 0.0f;
    const OpposedPair pair = p.w > 0 ? find_opposed(contacts, begin, end, x) : OpposedPair{};
    Vec3 step{0, 0, 0};  // of the accumulated delta
    const auto at = [&] { return x + moves * step; };
    for (uint32_t k = begin; k < end; ++k) {
      if (!pair.has(k) && !is_attachment(contacts[k])) step += recorded * one(contacts[k], at(), p.w);
    }
    if (pair.is_there())
      step += recorded * both(two_sided_between(contacts[pair.a], contacts[pair.b], p.w), at());
    all.position[i] = pbd::with_w(at(), p.w);
    all.accumulated_delta[i] = pbd::shifted(all.accumulated_delta[i], step);
  }
};

template <class D>
TwoSidedContacts two_sided_contacts(const pbd::Substep<D>& substep) {
  return {contact_projection(substep), substep.effective_mass, substep.particles.sorted};
}

}  // namespace meniscus::collision
