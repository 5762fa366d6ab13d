// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels for bodies that other solids hold or load. Fluid sees such a body where the solids let it go,
// in each iteration.
#pragma once

#include "collision/body/body_kernels.h"
#include "collision/rigid_contact/bearing.h"

namespace meniscus::collision::body_kernels {

/// Frees the fluid's contacts with held bodies of the body's mass: during the iterations these bodies move by
/// RespondHeld alone. Other contacts keep their fraction.
struct FreeHeld {
  View<const uint32_t> grouped;
  View<const BodyProxy> bodies;
  ContactView contacts;
  bool gives_back;  ///< the body's mass, after the last iteration

  MENISCUS_HD void operator()(uint32_t k) const {
    if (k >= contacts.total()) return;
    Contact& c = contacts.contacts[grouped[k]];
    if (c.body >= bodies.count || !bodies[c.body].is_held || k >= bodies[c.body].unyielding) return;
    const BodyProxy& body = bodies[c.body];
    const float fraction = split_of(GroupCounts::of(body), true);
    c.body_inverse_mass = gives_back ? fraction * unloaded_inverse_mass_at(body, c.arm, c.normal) : 0;
  }
};

/// Whether the particle, of fluid at a held body, moves along with the surface: it is pressed, or too near.
MENISCUS_HD inline bool rides(const Contact& c, const pbd::Vec4& particle) {
  return c.body_inverse_mass == 0 && particle.w > 0 &&
         (dot(multiplier_sum(c), c.normal) > 0 || plane_distance(c, particle.xyz()) < c.radius);
}

/// Sums up in lanes the mass of the particles that ride on each held body.
struct SumRiding {
  View<const uint32_t> grouped;
  View<const BodyProxy> bodies;
  ContactView contacts;
  View<const pbd::Vec4> position;
  View<Sym6> partial;
  uint32_t lanes;

  MENISCUS_HD void operator()(uint32_t n) const {
    const BodyProxy& body = bodies[n / lanes];
    if (!body.is_held) return;
    Sym6 sum{};
    for (uint32_t k = body.first + n % lanes; k < body.unyielding; k += lanes) {
      const Contact& c = contacts.contacts[grouped[k]];
      const pbd::Vec4 x = position[contacts.particle[grouped[k]]];
      if (rides(c, x)) sum.add({c.normal, cross(c.arm, c.normal)}, 1 / x.w);
    }
    partial[n] = sum;
  }
};

/// The mass of a body, in world axes.
MENISCUS_HD inline Sym6 mass_of(const BodyProxy& body) {
  const Vec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, none{0, 0, 0}, i = body.inverse_inertia;
  const float inertia[] = {1 / i.x, 1 / i.y, 1 / i.z};
  Sym6 mass{};
  for (int k = 0; k < 3; ++k) {
    mass.add({axes[k], none}, 1 / body.inverse_mass);
    mass.add({none, rotate(body.pose.rotation, axes[k])}, inertia[k]);
  }
  return mass;
}

/// Counts in lanes each body's contacts with cloth, attachments among them.
struct CountCloth {
  View<const uint32_t> grouped;
  View<const BodyProxy> bodies;
  View<const uint32_t> particle;  ///< of each contact
  View<uint32_t> partial;
  uint32_t lanes, fluid;  ///< the number of particles of fluid

  MENISCUS_HD void operator()(uint32_t n) const {
    const BodyProxy& body = bodies[n / lanes];
    uint32_t count = 0;
    if (body.is_held)
      for (uint32_t k = body.first + n % lanes; k < body.end; k += lanes)
        count += particle[grouped[k]] >= fluid;
    partial[n] = count;
  }
};

/// Cloth and attachments carry a body by the fraction that Split gave. A body that meets them is not held
/// here.
struct StartHeld {
  View<BodyProxy> bodies;
  View<HeldBody> held;
  View<const uint32_t> on_cloth;
  uint32_t lanes;

  MENISCUS_HD void operator()(uint32_t b) const {
    held[b] = {};
    BodyProxy& body = bodies[b];
    uint32_t count = 0;
    for (uint32_t k = 0; k < lanes; ++k) count += on_cloth[b * lanes + k];
    body.is_held = body.is_held && count == 0 && body.inverse_mass > 0;
  }
};

/// Moves each held body by what particles and solids exert on it, as if the particles that ride on it were
/// part of it.
struct RespondHeld {
  View<const BodyProxy> bodies;
  View<const ContactSum> partial;
  View<const Sym6> riding;
  View<HeldBody> held;
  uint32_t lanes;

  MENISCUS_HD void operator()(uint32_t b) const {
    const BodyProxy& body = bodies[b];
    if (!body.is_held) return;
    HeldBody& to = held[b];
    const Sym6 own = mass_of(body);
    const ContactSum sum = sum_of_lanes(partial, b, lanes);
    const Six lacking = to.borne - own * to.motion - Six{sum.push.xyz(), sum.twist.xyz()};
    Sym6 all = own;
    for (uint32_t k = 0; k < lanes; ++k) all += riding[b * lanes + k];
    to.give = inverse(all);
    to.before = to.motion;
    to.motion += to.give * lacking;
    to.moves = 1;
  }
};

/// Moves the planes of held bodies, and the particles that ride on them. What these weigh against the motion
/// the body gets as their push. So what it gets and how it moves agree after each iteration.
struct Ride {
  View<const BodyProxy> bodies;
  View<const HeldBody> held;
  View<pbd::Vec4> position, accumulated_delta;
  ContactView contacts;

  MENISCUS_HD void operator()(uint32_t n) const {
    const uint32_t i = contacts.touching_particle(n);
    if (i == pbd::no_index) return;
    const pbd::Vec4 x = position[i];
    Vec3 moved{0, 0, 0};
    for (uint32_t k = contacts.start[i]; k < contacts.start[i + 1]; ++k) {
      Contact& c = contacts.contacts[k];
      if (c.body >= bodies.count || !bodies[c.body].is_held) continue;
      const HeldBody& body = held[c.body];
      const Vec3 step = motion_at(body.motion - body.before, c.arm);
      if (rides(c, x)) {
        const float along = dot(step, c.normal);
        c.normal_multiplier += along / x.w;
        moved += along * c.normal;
      }
      c.point += step;
      c.surface_motion += step;
    }
    if (moved == Vec3{0, 0, 0}) return;
    position[i] = shifted(x, moved);
    accumulated_delta[i] = shifted(accumulated_delta[i], moved);
  }
};

/// Writes where contacts have moved held bodies.
struct NoteHeld {
  View<const BodyProxy> bodies;
  View<const HeldBody> held;
  View<ContactMotion> motion;

  MENISCUS_HD void operator()(uint32_t b) const {
    if (bodies[b].is_held) motion[b] = {held[b].motion.linear, held[b].motion.angular};
  }
};

}  // namespace meniscus::collision::body_kernels
