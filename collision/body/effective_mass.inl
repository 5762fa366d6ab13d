// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Kernels and functions of EffectiveMass.
#pragma once

#include "collision/body/effective_mass.h"
#include "collision/contact/two_sided_contact.h"

namespace meniscus::collision {

namespace effective_mass_kernels {

using pbd::Contact;
using pbd::Vec4;
using pbd::View;

/// Contacts of vertices with bodies that cloth can move.
struct BodyContacts {
  pbd::ContactView contacts;
  View<const Vec4> position;
  View<Vec4> effective_mass;
  uint32_t sorted;  ///< see ParticleView

  /// The particle at index n among those that touch, or no_index if it is no vertex.
  MENISCUS_HD uint32_t vertex(uint32_t n) const {
    const uint32_t i = contacts.touching_particle(n);
    return i != pbd::no_index && i >= sorted && i - sorted < effective_mass.count ? i : pbd::no_index;
  }
  MENISCUS_HD static bool yields(const Contact& c) {
    return c.body < pbd::on_cloth && c.body_inverse_mass > 0 && !is_attachment(c);
  }
  MENISCUS_HD static float mass(const Contact& c) { return 1 / c.body_inverse_mass; }
};

/// Computes the effective mass of each vertex, and applies friction.
struct Weigh {
  BodyContacts of;
  TwoSidedContacts two_sided;

  MENISCUS_HD void operator()(uint32_t n) const {
    const uint32_t i = of.vertex(n);
    if (i == pbd::no_index) return;
    const Vec4 x = of.position[i];
    if (x.w == 0) return;  // it resists any motion already
    float mass = 0;
    for (uint32_t k = of.contacts.start[i]; k < of.contacts.start[i + 1]; ++k) {
      const Contact& c = of.contacts.contacts[k];
      if (BodyContacts::yields(c) && contact_presses(c, x.xyz())) mass += BodyContacts::mass(c);
    }
    of.effective_mass[i - of.sorted] = {0, 0, 0, mass};
    if (mass > 0) two_sided.apply_friction(i);
  }
};

/// Gives each contact its part of the impulse. For an iteration a contact may also pull, until the chains
/// account for its push. Friction does not bound the tangential part, because a vertex that moves sideways
/// takes its support along.
struct TransferPush {
  BodyContacts of;

  MENISCUS_HD void operator()(uint32_t n) const {
    const uint32_t i = of.vertex(n);
    if (i == pbd::no_index) return;
    const Vec4 effective_mass = of.effective_mass[i - of.sorted];
    if (effective_mass.xyz() == Vec3{0, 0, 0}) return;
    float mass = 0;
    for (uint32_t k = of.contacts.start[i]; k < of.contacts.start[i + 1]; ++k) {
      const Contact& c = of.contacts.contacts[k];
      if (BodyContacts::yields(c)) mass += BodyContacts::mass(c);
    }
    for (uint32_t k = of.contacts.start[i]; k < of.contacts.start[i + 1]; ++k) {
      Contact& c = of.contacts.contacts[k];
      if (!BodyContacts::yields(c)) continue;
      const Vec3 push = -BodyContacts::mass(c) / mass * effective_mass.xyz();
      const float normal = pbd::max(dot(push, c.normal), -c.normal_multiplier);
      c.normal_multiplier += normal;
      c.density_push += push - normal * c.normal;
    }
  }
};

}  // namespace effective_mass_kernels

template <class D>
effective_mass_kernels::BodyContacts EffectiveMass<D>::contacts(const pbd::Substep<D>& substep) const {
  return {substep.contacts, substep.particles.position, substep.effective_mass, substep.particles.sorted};
}

template <class D>
void EffectiveMass<D>::begin(pbd::Substep<D>& substep) {
  if (!bodies_.any_moved() || vertices_ == 0) return;
  effective_mass_.resize_discard(vertices_);
  effective_mass_.fill(0);
  substep.effective_mass = effective_mass_.view();
}

template <class D>
void EffectiveMass<D>::project(pbd::Substep<D>& substep, int) {
  if (substep.effective_mass.count == 0) return;
  device_.parallel_for("effective mass/weigh", substep.contacts.contacts.count,
                       effective_mass_kernels::Weigh{contacts(substep), two_sided_contacts(substep)});
}

template <class D>
void EffectiveMass<D>::transfer_push(pbd::Substep<D>& substep) {
  if (substep.effective_mass.count == 0) return;
  device_.parallel_for("effective mass/transfer", substep.contacts.contacts.count,
                       effective_mass_kernels::TransferPush{contacts(substep)});
}

}  // namespace meniscus::collision
