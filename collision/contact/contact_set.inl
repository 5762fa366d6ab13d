// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Kernels and functions of ContactSet.
#pragma once

#include <utility>

#include "collision/contact/contact_set.h"
#include "collision/contact/tuning.h"
#include "collision/contact/two_sided_contact.h"
#include "pbd/device/scalar.h"

namespace meniscus::collision {

namespace contact_kernels {

using pbd::Contact;
using pbd::ContactView;
using pbd::Vec4;
using pbd::View;

struct Project {
  TwoSidedContacts contacts;

  MENISCUS_HD void operator()(uint32_t n) const {
    const uint32_t i = contacts.all.contacts.touching_particle(n);
    if (i != pbd::no_index) contacts.project(i);
  }
};

struct Bounce {
  View<Vec4> velocity;
  pbd::Withstanding held;
  float dt;
  float resting_speed;  ///< m/s: slower impacts do not bounce; otherwise nothing would come to rest

  MENISCUS_HD void operator()(uint32_t n) const {
    const ContactView& contacts = held.contacts;
    const uint32_t i = contacts.touching_particle(n);
    if (i == pbd::no_index) return;
    const uint32_t begin = contacts.start[i], end = contacts.start[i + 1];
    const Vec4 before = velocity[i];
    Vec3 v = before.xyz(), withstood{0, 0, 0};  // kg·m/s
    const float w = is_held(contacts, i, held.position[i].w) ? 0 : held.position[i].w;
    Contact next = contacts.contacts[begin];
    for (uint32_t k = begin; k < end; ++k) {
      const Contact c = next;
      next = contacts.contacts[k + 1 < end ? k + 1 : k];
      const float impulse = c.normal_multiplier > 0 ? parting_impulse(c, v, w) : 0;
      if (impulse == 0) continue;
      v += w * impulse * c.normal;
      withstood += impulse * c.normal;
      contacts.contacts[k].normal_multiplier = c.normal_multiplier + dt * impulse;
    }
    if (!(v == before.xyz())) velocity[i] = pbd::with_w(v, before.w);
    if (w == 0 && !(withstood == Vec3{0, 0, 0})) held.add(i, dt * withstood);
  }

  /// The impulse, kg·m/s, that the contact must add to reach its speed of separation.
  MENISCUS_HD float parting_impulse(const Contact& c, Vec3 v, float w) const {
    const float bounce = c.approach_speed < -resting_speed ? -c.restitution * c.approach_speed : 0;
    const float lacking = bounce - dot(v - c.surface_motion / dt, c.normal);
    return lacking > 0 ? pbd::closing_impulse(lacking, w + c.body_inverse_mass) : 0;
  }
};

}  // namespace contact_kernels

template <class D>
void ContactSet<D>::project(pbd::Substep<D>& substep, int) {
  if (std::exchange(substep.are_contacts_projected, false)) return;
  device_.parallel_for("contacts/project", substep.contacts.contacts.count,
                       contact_kernels::Project{two_sided_contacts(substep)});
}

template <class D>
void ContactSet<D>::end(pbd::Substep<D>& substep) {
  constexpr float gravity_scale = 9.81f;  // m/s²
  device_.parallel_for("contacts/bounce", substep.contacts.contacts.count,
                       contact_kernels::Bounce{substep.particles.velocity, withstanding(substep), substep.dt,
                                               shape_tuning::resting_substeps * gravity_scale * substep.dt});
}

}  // namespace meniscus::collision
