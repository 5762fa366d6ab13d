// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What holds a particle at its contacts, in an iteration of the solve. The formulas are in
// collision/contact_set.h.
#pragma once

#include "pbd/contacts.h"
#include "pbd/device/scalar.h"
#include "pbd/substep.h"

namespace meniscus::pbd {

struct ContactProjection {
  View<Vec4> position, moved;
  View<const Vec4> previous;
  View<const uint32_t> slot;
  ContactView contacts;
  View<const Vec4> pressed;  ///< see Substep::pressed
  uint32_t sorted;           ///< see ParticleView

  /// Friction alone, of a particle that has contacts.
  MENISCUS_HD void hold_back(uint32_t i) const {
    const Vec4 p = position[i];
    if (p.w == 0) return;
    const Vec3 x = p.xyz(), start = previous[i].xyz();
    Vec3 step{0, 0, 0};
    for (uint32_t k = contacts.start[i]; k < contacts.start[i + 1]; ++k) {
      Contact& c = contacts.contacts[k];
      if (!is_tie(c) && c.friction > 0) step += p.w * hold_back(c, x + step - start, p.w);
    }
    position[i] = pbd::with_w(x + step, p.w);
    moved[i] = pbd::with_w(moved[i].xyz() + step, 0);
  }

  /// Of particle i, which has contacts.
  MENISCUS_HD void project(uint32_t i) const {
    const uint32_t begin = contacts.start[i], end = contacts.start[i + 1];
    Vec4 p = position[i];
    if (p.w == 0) return;
    const float tighter = pbd::share_of_radius(slot[i]);
    const bool is_held_back = i - sorted < pressed.count && pressed[i - sorted].w > 0;
    const Vec3 x = p.xyz(), start = previous[i].xyz();
    Vec3 step{0, 0, 0};
    // All of a contact is loaded at once, and the next one before what this one does is written.
    Contact next = contacts.contacts[begin];
    for (uint32_t k = begin; k < end; ++k) {
      Contact c = next;
      next = contacts.contacts[k + 1 < end ? k + 1 : k];
      if (is_tie(c)) continue;
      step += p.w * push_out(c, x + step, p.w, tighter * c.radius);
      if (c.friction > 0 && !is_held_back) step += p.w * hold_back(c, x + step - start, p.w);
      Contact& to = contacts.contacts[k];
      to.normal_multiplier = c.normal_multiplier;
      to.tangent_multiplier = c.tangent_multiplier;
    }
    position[i] = pbd::with_w(x + step, p.w);
    moved[i] = pbd::with_w(moved[i].xyz() + step, 0);
  }

 private:
  /// What the contact adds to its normal push, kg·m.
  MENISCUS_HD static Vec3 push_out(Contact& c, Vec3 x, float w, float radius) {
    const float old = c.normal_multiplier, distance = plane_distance(c, x);
    // Adhesion reaches as far again as the contact.
    const float least = distance < 2 * radius ? -c.adhesion : 0.0f;
    c.normal_multiplier = pbd::max(least, old + (radius - distance) / (w + c.body_inverse_mass));
    return (c.normal_multiplier - old) * c.normal;
  }

  /// What it adds to its friction, kg·m.
  MENISCUS_HD static Vec3 hold_back(Contact& c, Vec3 way, float w) {
    const Vec3 on_surface = way - c.surface_motion;
    const Vec3 slip = on_surface - dot(on_surface, c.normal) * c.normal;
    Vec3 wanted = c.tangent_multiplier - slip / (w + c.body_inverse_mass);
    const float load = c.normal_multiplier + pbd::max(0.0f, dot(c.density_push, c.normal));
    const float most = c.friction * pbd::max(0.0f, load), size = length(wanted);
    if (size > most) wanted = (most / size) * wanted;
    const Vec3 old = c.tangent_multiplier;
    c.tangent_multiplier = wanted;
    return wanted - old;
  }
};

template <class D>
ContactProjection contact_projection(const Substep<D>& substep) {
  const ParticleView& p = substep.particles;
  return {p.position, p.moved, p.previous, p.slot, substep.contacts, substep.pressed, p.sorted};
}

}  // namespace meniscus::pbd
