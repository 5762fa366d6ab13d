// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Contacts as constraints read them. Shapes, bodies and triangles all act on particles through contacts, so
// the fluid depends on nothing else.
#pragma once

#include "pbd/device/base/atomics.h"
#include "pbd/device/base/view.h"
#include "pbd/math/vec.h"
#include "pbd/tuning.h"

namespace meniscus::pbd {

inline constexpr uint32_t no_index = 0xffffffff;
/// A value of Contact::body: the surface is that of cloth, whose vertices are particles.
inline constexpr uint32_t on_cloth = 0xfffffffe;

/// One particle near a surface, found once a substep. During the iterations the surface is the plane through
/// `point`. The plane of a body's surface moves with the body.
struct alignas(16) Contact {
  Vec3 point;      ///< m, on the surface
  uint32_t solid;  ///< the user's shape, body or piece of cloth; no_index for a contact that does nothing
  Vec3 normal;     ///< unit, out of the solid
  float fraction;  ///< of the half-space's kernel integral: 1 on a plane, less over edges and thin solids
  Vec3 tangent_multiplier;  ///< kg·m, accumulated friction of this substep; divided by the length of the
                            ///< substep, an impulse
  float normal_multiplier;  ///< kg·m, accumulated non-penetration and restitution
  Vec3 density_push;        ///< kg·m, accumulated, on the particle: the forces of fluid through this surface
                      ///< (density constraint, surface tension), and the force by which cloth carries the
                      ///< particle
  float friction;           ///< Coulomb's μ
  Vec3 surface_motion;      ///< m, of the surface here, from the substep's start to now
  float body_inverse_mass;  ///< 1/kg, of the body along the normal, split among its contacts; 0: immovable. A
                            ///< particle that overlaps a solid when it is created has a value above 0 in any
                            ///< case
  Vec3 arm;                 ///< m, from the body's centre of mass to where impulses act
  uint32_t body;            ///< the rigid body, no_index or on_cloth
  float approach_speed;  ///< m/s along the normal, before the substep's solve; negative towards the surface
  float restitution;     ///< 0 to 1
  float adhesion;        ///< kg·m, the largest pull of the surface in this substep
  float radius;  ///< m: the particle's centre stops at this distance; negative: the particle is attached to
                 ///< `point`
};

/// The fraction of a contact's radius at which a particle stops, slightly different for each. Otherwise
/// particles in a corner could end at the very same point, where no force separates them.
MENISCUS_HD inline float fraction_of_radius(uint32_t number) {
  uint32_t x = number * 2654435761u;
  x ^= x >> 15;
  return 1 - contact_tuning::radius_spread * (static_cast<float>(x & 0xffff) * (1.0f / 65536));
}

/// Whether the contact attaches the particle to its point, in all directions. BodyAttachments alone solves
/// attachments.
MENISCUS_HD inline bool is_attachment(const Contact& c) {
  return c.radius < 0;
}

/// The accumulated multiplier of a contact on its particle, kg·m. The solid receives the opposite.
MENISCUS_HD inline Vec3 multiplier_sum(const Contact& c) {
  return c.normal_multiplier * c.normal + c.tangent_multiplier + c.density_push;
}

/// The particles that have contacts, in arbitrary order. Particles with one contact are at the front, those
/// with several at the back. So adjacent threads have equal work.
struct TouchingView {
  View<uint32_t> list;    ///< its length is the capacity for contacts
  View<uint32_t> counts;  ///< of particles with one, and with several

  /// Beyond the list's capacity nothing is stored. More contacts than the capacity exist then, and the step
  /// is repeated. Until then both ends may meet, so entries are stored atomically.
  MENISCUS_HD void add(uint32_t i, bool has_several) const {
    // Each branch has its own atomic operation, so that the compiler aggregates those of a warp.
    const uint32_t n = has_several ? atomic_add(counts[1], 1) : atomic_add(counts[0], 1);
    if (n < list.count) atomic_store(list[has_several ? list.count - 1 - n : n], i);
  }
  /// The k-th entry, or no_index. For kernels with a thread an entry, which run over the capacity.
  MENISCUS_HD uint32_t at(uint32_t k, View<const uint32_t> start) const {
    const uint32_t i = list[k];  // loaded together with the counts, whether it is valid or not
    const bool is_one = k < counts[0] || list.count - k <= counts[1];
    return is_one && i < start.count - 1 && start[i] != start[i + 1] ? i : no_index;
  }
};

/// Contacts of particle i: contacts[start[i]] to contacts[start[i + 1] − 1].
struct ContactView {
  View<const uint32_t> start;     ///< of each owned particle, and the total
  View<Contact> contacts;         ///< as many as the capacity: the host does not know the total
  View<const uint32_t> particle;  ///< the particle of each contact
  TouchingView touching;
  bool any_moving = false;  ///< whether solids may move; for the host, as kernels for fixed solids are faster

  /// The number of contacts.
  MENISCUS_HD uint32_t total() const { return start[start.count - 1]; }
  /// The contacts of the first `particles` alone.
  ContactView of_first(uint32_t particles) const {
    return {start.first(particles + 1), contacts, particle, touching, any_moving};
  }
  MENISCUS_HD uint32_t touching_particle(uint32_t k) const { return touching.at(k, start); }
};

/// Where contact sources record the number of contacts that they find.
struct ContactCounter {
  View<uint32_t> counts;  ///< of each particle
  TouchingView touching;
  bool lists = false;  ///< this source is the last, so the particles are listed

  MENISCUS_HD void add(uint32_t i, uint32_t found) const {
    const uint32_t all = counts[i] + found;
    if (found) counts[i] = all;
    if (lists && all) touching.add(i, all > 1);
  }
};

/// Where contact sources write the contacts that they find.
struct ContactWriter {
  View<const uint32_t> start;
  View<uint32_t> remaining;  ///< of each particle, the contacts that are not written yet
  View<Contact> contacts;
  View<uint32_t> particle;
  TouchingView touching;

  /// Fills the contacts of i that were counted but not written. Counting and writing are compiled separately,
  /// and may differ by a rounding.
  MENISCUS_HD void finish(uint32_t i, const Contact& inert) const {
    while (remaining[i] > 0 && remaining[i] <= start[i + 1] - start[i]) write(i, inert);
  }
  MENISCUS_HD void write(uint32_t i, const Contact& contact) const {
    const uint32_t n = start[i + 1] - remaining[i]--;
    if (n < start[i] || n >= start[i + 1]) return;  // beyond the capacity: the step will be repeated
    contacts[n] = contact;
    particle[n] = i;
  }
};

/// The contact by which an immovable body holds particle i, or no_index. A particle's attachments are its
/// first contacts.
MENISCUS_HD inline uint32_t holding_attachment(const ContactView& contacts, uint32_t i) {
  for (uint32_t k = contacts.start[i]; k < contacts.start[i + 1]; ++k) {
    const Contact& c = contacts.contacts[k];
    if (!is_attachment(c)) return no_index;
    if (c.body_inverse_mass == 0) return k;
  }
  return no_index;
}

/// Whether nothing moves particle i, of inverse mass w. What an immovable body holds has w = 0 only while
/// constraints are solved.
MENISCUS_HD inline bool is_held(const ContactView& contacts, uint32_t i, float w) {
  return w == 0 || holding_attachment(contacts, i) != no_index;
}

/// Records what held particles withstand after the solve.
struct Withstanding {
  View<const Vec4> position;
  View<Vec4> accumulated_delta;
  ContactView contacts;

  /// Adds a positional impulse, kg·m, to what held particle i has withstood.
  MENISCUS_HD void add(uint32_t i, Vec3 push) const {
    if (position[i].w == 0) {
      accumulated_delta[i] = shifted(accumulated_delta[i], push);
    } else {
      Contact& holder = contacts.contacts[holding_attachment(contacts, i)];
      holder.tangent_multiplier = holder.tangent_multiplier - push;
    }
  }
};

/// Signed distance of p from the contact's plane, m.
MENISCUS_HD inline float plane_distance(const Contact& contact, Vec3 p) {
  return dot(contact.normal, p - contact.point);
}

/// kg·m, the lower limit of the normal multiplier at this distance. Adhesion has a short reach.
MENISCUS_HD inline float least_push(const Contact& contact, float distance) {
  return distance < contact_tuning::adhesion_reach * contact.radius ? -contact.adhesion : 0.0f;
}

/// m, how far a particle with this displacement has slipped along the surface.
MENISCUS_HD inline Vec3 slip(const Contact& contact, Vec3 displacement) {
  const Vec3 on_surface = displacement - contact.surface_motion;
  return on_surface - dot(on_surface, contact.normal) * contact.normal;
}

/// kg·m, the largest friction by Coulomb's law.
MENISCUS_HD inline float most_friction(const Contact& contact) {
  const float load = contact.normal_multiplier + max(0.0f, dot(contact.density_push, contact.normal));
  return contact.friction * max(0.0f, load);
}

}  // namespace meniscus::pbd
