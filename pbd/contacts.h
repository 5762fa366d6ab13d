// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Contacts as constraints read them. Shapes, bodies and triangles all reach a particle as a contact, so the
// fluid need know nothing else.
#pragma once

#include "pbd/device/base/atomics.h"
#include "pbd/device/base/view.h"
#include "pbd/math/vec.h"

namespace meniscus::pbd {

inline constexpr uint32_t no_index = 0xffffffff;
/// In the place of a body: the surface is that of a sheet of triangles, whose vertices are particles.
inline constexpr uint32_t on_cloth = 0xfffffffe;

/// One particle near a surface. Found once a substep; the surface is taken as the plane through `point` while
/// the substep's iterations run. Where the surface belongs to a body, the plane moves along with it.
struct alignas(16) Contact {
  Vec3 point;      ///< m, on the surface
  uint32_t solid;  ///< the user's shape, body or piece of cloth; no_index for a contact that does nothing
  Vec3 normal;     ///< unit, out of the solid
  float fraction;  ///< of the half-space's share in the kernel: 1 on a plane, less over edges and thin things
  Vec3 tangent_multiplier;  ///< kg·m, friction so far in this substep; over the substep's length it is the
                            ///< impulse
  float normal_multiplier;  ///< kg·m, non-penetration and bounce so far
  Vec3 density_push;    ///< kg·m, on the particle, so far: what fluid pushes and pulls through this surface,
                        ///< by the density constraint and surface tension, and what a sheet carries it by
  float friction;       ///< Coulomb's μ
  Vec3 surface_motion;  ///< m, of the surface here, from the substep's start to now
  float body_inverse_mass;  ///< 1/kg: how the body gives way along the normal, split among its contacts; 0:
                            ///< not at all. What was put into a solid meets one that gives way in any case
  Vec3 arm;                 ///< m, from the body's centre of mass to where impulses act
  uint32_t body;            ///< the rigid body, no_index or on_cloth
  float approach_speed;  ///< m/s along the normal, before the substep's solve; negative towards the surface
  float restitution;     ///< 0 to 1
  float adhesion;        ///< kg·m, the most that the surface pulls back with in this substep
  float radius;          ///< m: the particle's centre stops at this distance; negative: it is held at `point`
};

/// Of a contact's radius, where a particle stops: a little less for each. Particles that a corner would hold
/// on the very same point, where nothing could part them again, come to rest a little apart.
MENISCUS_HD inline float fraction_of_radius(uint32_t number) {
  uint32_t x = number * 2654435761u;
  x ^= x >> 15;
  return 1 - 0.01f * (static_cast<float>(x & 0xffff) * (1.0f / 65536));
}

/// Whether the particle is attached to the contact's point, in all directions: an attachment, not a touch. It
/// is for BodyAttachments alone to solve.
MENISCUS_HD inline bool is_attachment(const Contact& c) {
  return c.radius < 0;
}

/// What a contact has done to its particle so far, kg·m; the solid has got the opposite.
MENISCUS_HD inline Vec3 multiplier_sum(const Contact& c) {
  return c.normal_multiplier * c.normal + c.tangent_multiplier + c.density_push;
}

/// The particles that have contacts, in an order that chance makes. Those with one stand at the front, those
/// with several at the back: threads that are side by side have as much to do.
struct TouchingView {
  View<uint32_t> list;    ///< as long as there is room for contacts
  View<uint32_t> counts;  ///< of particles with one, and with several

  /// Where there is no room, there will be more, and the step is done again.
  MENISCUS_HD void add(uint32_t i, bool has_several) const {
    // A count by itself: threads of a warp that add to it do so at once, and stay side by side.
    const uint32_t n = has_several ? atomic_add(counts[1], 1) : atomic_add(counts[0], 1);
    if (n < list.count) list[has_several ? list.count - 1 - n : n] = i;
  }
  /// For work on each by itself, which runs over as many as there may be: the k-th, or no_index.
  MENISCUS_HD uint32_t at(uint32_t k, View<const uint32_t> start) const {
    const uint32_t i = list[k];  // at once with the counts, whether it counts or not
    const bool is_one = k < counts[0] || list.count - k <= counts[1];
    return is_one && i < start.count - 1 && start[i] != start[i + 1] ? i : no_index;
  }
};

/// Contacts of particle i: contacts[start[i]] to contacts[start[i + 1] − 1].
struct ContactView {
  View<const uint32_t> start;     ///< of each owned particle, and the total
  View<Contact> contacts;         ///< as many as there is room for: the host does not know the total
  View<const uint32_t> particle;  ///< whose each contact is
  TouchingView touching;
  bool any_moving = false;  ///< whether solids may move; for the host: kernels for fixed ones are leaner

  /// How many there are.
  MENISCUS_HD uint32_t total() const { return start[start.count - 1]; }
  /// Those of the first `particles` alone.
  ContactView of_first(uint32_t particles) const {
    return {start.first(particles + 1), contacts, particle, touching, any_moving};
  }
  MENISCUS_HD uint32_t touching_particle(uint32_t k) const { return touching.at(k, start); }
};

/// Where the sources of contacts count what they find.
struct ContactCounter {
  View<uint32_t> counts;  ///< of each particle
  TouchingView touching;
  bool lists = false;  ///< what has been counted is all there is: particles are listed

  MENISCUS_HD void add(uint32_t i, uint32_t found) const {
    const uint32_t all = counts[i] + found;
    if (found) counts[i] = all;
    if (lists && all) touching.add(i, all > 1);
  }
};

/// Where the sources of contacts put what they find.
struct ContactWriter {
  View<const uint32_t> start;
  View<uint32_t> remaining;  ///< of each particle's contacts, those that are not written yet
  View<Contact> contacts;
  View<uint32_t> particle;
  TouchingView touching;

  /// Fills up what was counted for i and not written. Counting and writing are compiled apart, and may judge
  /// differently by a rounding.
  MENISCUS_HD void finish(uint32_t i, const Contact& inert) const {
    while (remaining[i] > 0 && remaining[i] <= start[i + 1] - start[i]) write(i, inert);
  }
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

/// kg·m: the normal multiplier is no less, at this distance. Adhesion reaches as far again as the contact.
MENISCUS_HD inline float least_push(const Contact& contact, float distance) {
  return distance < 2 * contact.radius ? -contact.adhesion : 0.0f;
}

/// m: how far a particle that has gone this way has slipped along the surface.
MENISCUS_HD inline Vec3 slip(const Contact& contact, Vec3 displacement) {
  const Vec3 on_surface = displacement - contact.surface_motion;
  return on_surface - dot(on_surface, contact.normal) * contact.normal;
}

/// kg·m, by Coulomb's law.
MENISCUS_HD inline float most_friction(const Contact& contact) {
  const float load = contact.normal_multiplier + max(0.0f, dot(contact.density_push, contact.normal));
  return contact.friction * max(0.0f, load);
}

}  // namespace meniscus::pbd
