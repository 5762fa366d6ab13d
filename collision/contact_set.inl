// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "collision/contact_set.h"
#include "pbd/device/scalar.h"

namespace meniscus::collision {

namespace contact_kernels {

using pbd::Contact;
using pbd::ContactView;
using pbd::Vec4;
using pbd::View;

/// A different small number for each particle. Particles that a corner would hold on the very same point,
/// where nothing could part them again, come to rest a little apart.
MENISCUS_HD inline float jitter(uint32_t slot) {
  uint32_t x = slot * 2654435761u;
  x ^= x >> 15;
  return static_cast<float>(x & 0xffff) * (1.0f / 65536);
}

struct Project {
  View<Vec4> position;
  View<const Vec4> previous;
  View<const uint32_t> slot;
  ContactView contacts;

  MENISCUS_HD void operator()(uint32_t n) const {
    const uint32_t i = contacts.particle_starting_at(n);
    if (i == pbd::no_index) return;
    const uint32_t begin = contacts.start[i], end = contacts.start[i + 1];
    Vec4 p = position[i];
    if (p.w == 0) return;
    const float radius = contacts.radius * (1 - 0.01f * jitter(slot[i]));
    Vec3 x = p.xyz();
    for (uint32_t k = begin; k < end; ++k) {
      Contact& c = contacts.contacts[k];
      x = push_out(c, x, p.w, radius);
      if (c.friction > 0) x = hold_back(c, x, x - previous[i].xyz(), p.w);
    }
    position[i] = pbd::with_w(x, p.w);
  }

  MENISCUS_HD static Vec3 push_out(Contact& c, Vec3 x, float w, float radius) {
    const float old = c.normal_multiplier;
    c.normal_multiplier = pbd::max(0.0f, old + (radius - plane_distance(c, x)) / w);
    return x + w * (c.normal_multiplier - old) * c.normal;
  }

  MENISCUS_HD static Vec3 hold_back(Contact& c, Vec3 x, Vec3 moved, float w) {
    const Vec3 slip = moved - dot(moved, c.normal) * c.normal;
    Vec3 wanted = c.tangent_multiplier - slip / w;
    const float most = c.friction * (c.normal_multiplier + pbd::max(0.0f, c.density_push));
    const float size = length(wanted);
    if (size > most) wanted = (most / size) * wanted;
    x += w * (wanted - c.tangent_multiplier);
    c.tangent_multiplier = wanted;
    return x;
  }
};

struct Bounce {
  View<Vec4> velocity;
  ContactView contacts;
  float resting_speed;  ///< m/s: slower impacts do not bounce, or nothing would come to rest

  MENISCUS_HD void operator()(uint32_t n) const {
    const uint32_t i = contacts.particle_starting_at(n);
    if (i == pbd::no_index) return;
    for (uint32_t k = contacts.start[i]; k < contacts.start[i + 1]; ++k) {
      const Contact& c = contacts.contacts[k];
      if (c.normal_multiplier == 0) continue;
      const Vec3 v = velocity[i].xyz();
      const float bounce = c.approach_speed < -resting_speed ? -c.restitution * c.approach_speed : 0;
      const float lacking = bounce - dot(v, c.normal);
      if (lacking > 0) velocity[i] = pbd::with_w(v + lacking * c.normal, 0);
    }
  }
};

}  // namespace contact_kernels

template <class D>
void ContactSet<D>::project(pbd::Substep<D>& substep, int) {
  const pbd::ParticleView& p = substep.particles;
  device_.parallel_for("contacts/project", substep.contacts.contacts.count,
                       contact_kernels::Project{p.position, p.previous, p.slot, substep.contacts});
}

template <class D>
void ContactSet<D>::end(pbd::Substep<D>& substep) {
  constexpr float gravity_scale = 9.81f;  // a contact at rest gathers about g·h_t within a substep
  device_.parallel_for(
      "contacts/bounce", substep.contacts.contacts.count,
      contact_kernels::Bounce{substep.particles.velocity, substep.contacts, 4 * gravity_scale * substep.dt});
}

}  // namespace meniscus::collision
