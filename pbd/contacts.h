// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Contacts as constraints read them. Shapes, bodies and triangles all reach a particle as a contact, so the
// fluid need know nothing else.
#pragma once

#include "pbd/device/view.h"
#include "pbd/math/vec.h"

namespace meniscus::pbd {

inline constexpr uint32_t no_index = 0xffffffff;

/// What sources find today is one particle at a surface; the other three are for triangles to come.
/// One particle, or up to four with weights (a triangle's corners against a particle), near a surface. Found
/// once a substep; the surface is taken as the plane through `point` while the substep's iterations run.
struct alignas(16) Contact {
  uint32_t particle[4];     ///< sorted indices; no_index beyond the last
  float weight[4];          ///< of each particle in the constraint: +1 for a particle alone
  Vec3 point;               ///< m, on the surface
  uint32_t body;            ///< the shape or body that the surface belongs to
  Vec3 normal;              ///< unit, out of the solid
  float distance;           ///< m, signed, when the contact was found
  Vec3 tangent_multiplier;  ///< kg·m, friction so far in this substep; over the substep's length it is the
                            ///< impulse
  float normal_multiplier;  ///< kg·m, non-penetration so far
  float density_push;    ///< kg·m along the normal, from the density constraint through this surface so far
  float approach_speed;  ///< m/s along the normal, before the substep's solve; negative towards the surface
  float friction;        ///< Coulomb's μ
  float restitution;     ///< 0 to 1
  float fraction;  ///< of the half-space's share in the kernel: 1 on a plane, less over edges and thin things
  float side;      ///< +1 where the particle started the substep on the normal's side, else −1
};

/// Contacts of particle i: contacts[start[i]] to contacts[start[i + 1] − 1].
struct ContactView {
  View<const uint32_t> start;     ///< of each owned particle, and the total
  View<Contact> contacts;         ///< as many as there is room for: the host does not know the total
  View<const uint32_t> particle;  ///< whose each contact is
  float radius = 0;               ///< m: a particle's centre stops at this distance

  /// For work on particles that have contacts, which runs over the contacts: the particle whose first one n
  /// is, or no_index.
  MENISCUS_HD uint32_t particle_starting_at(uint32_t n) const {
    const uint32_t i = particle[n], total = start[start.count - 1];
    return n < total && start[i] == n ? i : no_index;
  }
};

/// Where the sources of contacts put what they find.
struct ContactWriter {
  View<const uint32_t> start;
  View<uint32_t> remaining;  ///< of each particle's contacts, those that are not written yet
  View<Contact> contacts;
  View<uint32_t> particle;

  /// Fills up what was counted for i and not written. Counting and writing are compiled apart, and may judge
  /// differently by a rounding.
  MENISCUS_HD void finish(uint32_t i, const Contact& inert) const {
    while (remaining[i] > 0 && remaining[i] <= start[i + 1] - start[i]) write(i, inert);
  }
  MENISCUS_HD bool has_any(uint32_t i) const { return start[i] != start[i + 1]; }
  MENISCUS_HD void write(uint32_t i, const Contact& contact) const {
    const uint32_t n = start[i + 1] - remaining[i]--;
    if (n < start[i] || n >= start[i + 1]) return;  // no room for it: the step will be done again
    contacts[n] = contact;
    particle[n] = i;
  }
};

/// Signed distance of p from the contact's plane, m.
MENISCUS_HD inline float plane_distance(const Contact& contact, Vec3 p) {
  return dot(contact.normal, p - contact.point);
}

}  // namespace meniscus::pbd
