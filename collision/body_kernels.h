// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of body_set.inl. Contacts are grouped by body once a substep; sums over a body's contacts run
// in lanes of fixed stride, and over the lanes in order: the same bits each time.
#pragma once

#include "collision/body_proxy.h"

namespace meniscus::collision::body_kernels {

using pbd::Contact;
using pbd::ContactView;
using pbd::View;

/// Stands a proxy where its body is, and predicts where it gets to.
struct Predict {
  View<const RigidMotion> motion;
  View<const RigidMass> mass;
  View<BodyProxy> bodies;
  float dt;

  MENISCUS_HD void operator()(uint32_t b) const {
    const RigidMotion m = motion[b];
    BodyProxy body{};
    body.start = m.start;
    body.pose = moved(m.start, dt * m.velocity, dt * m.angular_velocity);
    body.inverse_mass = mass[b].inverse_mass;
    body.inverse_inertia = mass[b].inverse_inertia;
    bodies[b] = body;
  }
};

/// Where the body has really got to, its start being as it was.
struct Arrive {
  View<const RigidMotion> motion;
  View<BodyProxy> bodies;

  MENISCUS_HD void operator()(uint32_t b) const { bodies[b].pose = motion[b].start; }
};

/// A body as it is between steps: nothing moves it, and the way here is forgotten.
struct Rest {
  View<const RigidMotion> motion;
  View<BodyProxy> bodies;

  MENISCUS_HD void operator()(uint32_t b) const {
    BodyProxy body{};
    body.start = body.pose = motion[b].start;
    bodies[b] = body;
  }
};

struct Carry {
  View<const CarriedShape> carried;
  View<const BodyProxy> bodies;
  View<Shape> shapes;

  MENISCUS_HD void operator()(uint32_t k) const {
    const CarriedShape& c = carried[k];
    carry(c, bodies[c.body], shapes[c.shape]);
  }
};

/// The body of each contact, as a key to sort by; what belongs to none comes last.
struct NoteBodies {
  ContactView contacts;
  View<uint32_t> key, value;
  uint32_t body_count;

  MENISCUS_HD void operator()(uint32_t n) const {
    const uint32_t body = n < contacts.total() ? contacts.contacts[n].body : pbd::no_index;
    key[n] = body < body_count ? body : body_count;
    value[n] = n;
  }
};

/// How many of the sorted keys are below `bound`.
MENISCUS_HD inline uint32_t lower_bound(View<const uint32_t> keys, uint32_t bound) {
  uint32_t low = 0, high = keys.count;
  while (low < high) {
    const uint32_t middle = low + (high - low) / 2;
    keys[middle] < bound ? low = middle + 1 : high = middle;
  }
  return low;
}

struct FindGroups {
  View<const uint32_t> sorted_key;
  View<BodyProxy> bodies;

  MENISCUS_HD void operator()(uint32_t b) const {
    const uint32_t first = lower_bound(sorted_key, b);
    bodies[b].first = first;
    bodies[b].contacts = lower_bound(sorted_key, b + 1) - first;
  }
};

/// Each contact of a body gets its lever and its share of the body: as if the body were as many as it has
/// contacts, each of so much less mass (mass splitting, Tonge, Benevolenski & Voroshilov 2012). All of them
/// moving at once then move the body no further than it can go.
struct Split {
  View<const uint32_t> grouped;
  View<const BodyProxy> bodies;
  View<const pbd::Vec4> position;
  ContactView contacts;

  MENISCUS_HD void operator()(uint32_t k) const {
    if (k >= contacts.total()) return;
    const uint32_t n = grouped[k];
    Contact& c = contacts.contacts[n];
    if (c.body >= bodies.count) return;
    const BodyProxy& body = bodies[c.body];
    const float distance = plane_distance(c, position[contacts.particle[n]].xyz());
    c.arm = c.point + pbd::max(distance, contacts.radius) * c.normal - body.pose.position;
    c.body_inverse_mass = static_cast<float>(body.contacts) * inverse_mass_at(body, c.arm, c.normal);
  }
};

/// What a body's contacts have done to particles, kg·m and kg·m².
struct ContactSum {
  Vec3 push{0, 0, 0}, twist{0, 0, 0};
};

MENISCUS_HD inline void add(ContactSum& sum, const ContactSum& other) {
  sum.push += other.push;
  sum.twist += other.twist;
}

/// One lane of one body.
struct SumLanes {
  View<const uint32_t> grouped;
  View<const BodyProxy> bodies;
  View<const Contact> contacts;
  View<ContactSum> partial;
  uint32_t lanes;

  MENISCUS_HD void operator()(uint32_t n) const {
    const BodyProxy& body = bodies[n / lanes];
    ContactSum sum;
    for (uint32_t k = n % lanes; k < body.contacts; k += lanes) {
      const Contact& c = contacts[grouped[body.first + k]];
      const Vec3 push = multiplier_sum(c);
      add(sum, {push, cross(c.arm, push)});
    }
    partial[n] = sum;
  }
};

MENISCUS_HD inline ContactSum sum_of_lanes(View<const ContactSum> partial, uint32_t body, uint32_t lanes) {
  ContactSum sum;
  for (uint32_t k = 0; k < lanes; ++k) add(sum, partial[body * lanes + k]);
  return sum;
}

/// Moves each proxy by what its contacts have pushed it so far.
struct Move {
  View<const ContactSum> partial;
  View<BodyProxy> bodies;
  uint32_t lanes;

  MENISCUS_HD void operator()(uint32_t b) const {
    BodyProxy& body = bodies[b];
    if (body.inverse_mass == 0) return;
    const ContactSum sum = sum_of_lanes(partial, b, lanes);
    const Vec3 shift = -body.inverse_mass * sum.push, turn = -inverse_inertia_times(body, sum.twist);
    body.last_shift = shift - body.shift;
    body.last_turn = turn - body.turn;
    body.shift = shift;
    body.turn = turn;
  }
};

/// The planes of a body's contacts go with it.
struct Follow {
  View<const BodyProxy> bodies;
  ContactView contacts;

  MENISCUS_HD void operator()(uint32_t n) const {
    if (n >= contacts.total()) return;
    Contact& c = contacts.contacts[n];
    if (c.body_inverse_mass == 0) return;
    const BodyProxy& body = bodies[c.body];
    const Vec3 step = body.last_shift + cross(body.last_turn, c.arm);
    c.point += step;
    c.surface_motion += step;
  }
};

/// The substep's impulse on each body.
struct TakeImpulse {
  View<const ContactSum> partial;
  View<RigidImpulse> impulses;
  uint32_t lanes;
  float inverse_dt;

  MENISCUS_HD void operator()(uint32_t b) const {
    const ContactSum sum = sum_of_lanes(partial, b, lanes);
    impulses[b] = {-inverse_dt * sum.push, -inverse_dt * sum.twist};
  }
};

}  // namespace meniscus::collision::body_kernels
