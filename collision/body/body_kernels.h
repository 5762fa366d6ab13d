// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of body_set.inl. Contacts are grouped by body once a substep. Sums over a body's contacts run
// in lanes of fixed stride, and then over the lanes in order. So they have the same bits in each run.
#pragma once

#include "collision/body/proxy.h"
#include "collision/body/tuning.h"

namespace meniscus::collision::body_kernels {

using pbd::Contact;
using pbd::ContactView;
using pbd::View;

/// Places a proxy at its body's pose, and predicts the pose at the substep's end.
struct Predict {
  View<const RigidMotion> motion;
  View<const RigidMass> mass;
  View<BodyProxy> bodies;
  float dt;

  MENISCUS_HD BodyEnds ends(uint32_t b) const {
    const RigidMotion m = motion[b];
    return {m.start, displaced(m.start, dt * m.velocity, dt * m.angular_velocity)};
  }
  MENISCUS_HD void operator()(uint32_t b) const {
    const auto [start, pose] = ends(b);
    bodies[b] = {start,
                 pose,
                 mass[b].inverse_mass,
                 mass[b].inverse_inertia,
                 0,
                 0,
                 0,
                 0,
                 motion[b].loaded,
                 motion[b].yielding,
                 motion[b].is_held};
  }
};

/// Sets the pose that the body has really reached; its start stays.
struct Arrive {
  View<const RigidMotion> motion;
  View<BodyProxy> bodies;

  MENISCUS_HD BodyEnds ends(uint32_t b) const { return {bodies[b].start, motion[b].start}; }
  MENISCUS_HD void operator()(uint32_t b) const { bodies[b].pose = motion[b].start; }
};

/// A body between steps: nothing moves it, and its motion is reset.
struct Rest {
  View<const RigidMotion> motion;
  View<BodyProxy> bodies;

  MENISCUS_HD BodyEnds ends(uint32_t b) const { return {motion[b].start, motion[b].start}; }
  MENISCUS_HD void operator()(uint32_t b) const {
    BodyProxy body{};
    body.start = body.pose = motion[b].start;
    bodies[b] = body;
  }
};

/// Applies Place to each body, and then to each shape that a body carries, in one launch.
template <class Place>
struct WithShapes {
  Place place;
  View<const CarriedShape> carried;
  View<Shape> shapes;

  MENISCUS_HD void operator()(uint32_t k) const {
    if (k < place.bodies.count) return place(k);
    const CarriedShape& c = carried[k - place.bodies.count];
    carry(c, place.ends(c.body), shapes[c.shape]);
  }
};

/// The kinds by which a body's contacts are sorted, in this order. A key is contact_kinds times the body's
/// number, plus the kind.
enum ContactKind : uint32_t { is_free, is_unyielding, is_attached, contact_kinds };

/// Writes the key of each contact: its body and its kind. Contacts of no body come last.
struct NoteBodies {
  ContactView contacts;
  View<const pbd::Vec4> position;
  View<uint32_t> key, value;
  uint32_t body_count;

  MENISCUS_HD void operator()(uint32_t n) const {
    value[n] = n;
    key[n] = contact_kinds * body_count;
    if (n >= contacts.total()) return;
    const Contact& c = contacts.contacts[n];
    if (c.body >= body_count) return;
    key[n] = contact_kinds * c.body + (is_attachment(c)     ? is_attached
                                       : cannot_yield(n, c) ? is_unyielding
                                                            : is_free);
  }

  /// Whether the particle is pressed, and held or has no room: the gap between the contact's surface and
  /// another one is less than half of the particle.
  MENISCUS_HD bool cannot_yield(uint32_t n, const Contact& c) const {
    const uint32_t i = contacts.particle[n];
    const Vec3 x = position[i].xyz();
    const float distance = plane_distance(c, x);
    if (!(distance < c.radius)) return false;
    if (position[i].w == 0) return true;
    for (uint32_t k = contacts.start[i]; k < contacts.start[i + 1]; ++k) {
      const Contact& other = contacts.contacts[k];
      if (dot(c.normal, other.normal) < body_tuning::facing && distance + plane_distance(other, x) < c.radius)
        return true;
    }
    return false;
  }
};

/// Finds the ranges of contacts of each body, at the changes of the sorted keys. The counts are 0 before.
struct FindGroups {
  View<const uint32_t> sorted_key;
  View<BodyProxy> bodies;

  MENISCUS_HD void operator()(uint32_t n) const {
    const uint32_t key = sorted_key[n], b = key / contact_kinds;
    if (b >= bodies.count) return;
    BodyProxy& body = bodies[b];
    const uint32_t none = contact_kinds * b;  // less than the kind that follows
    const uint32_t before = n == 0 || sorted_key[n - 1] < none ? none : sorted_key[n - 1];
    if (n == 0 || sorted_key[n - 1] < none) body.first = n;
    if (key >= none + is_unyielding && before < none + is_unyielding) body.unyielding = n;
    if (key == none + is_attached && before != key) body.attached = n;
    if (n + 1 < sorted_key.count && sorted_key[n + 1] / contact_kinds == b) return;
    body.end = n + 1;
    if (key == none + is_free) body.unyielding = n + 1;
    if (key != none + is_attached) body.attached = n + 1;
  }
};

/// How many contacts of each kind a body has.
struct GroupCounts {
  uint32_t free, unyielding, attached;

  MENISCUS_HD static GroupCounts of(const BodyProxy& body) {
    return {body.unyielding - body.first, body.attached - body.unyielding, body.end - body.attached};
  }
};

/// Of how many parts of a body a contact has one: see Split.
MENISCUS_HD inline float split_of(const GroupCounts& all, bool is_free) {
  const uint32_t kinds = all.free > 0 && all.unyielding > 0 ? 2 : 1;
  return static_cast<float>((is_free ? all.free : all.unyielding) * kinds * (all.attached > 0 ? 2 : 1));
}

/// Gives each contact its lever arm and its fraction of the body (mass splitting, Tonge, Benevolenski &
/// Voroshilov 2012). The body is treated as if it were as many bodies as it has contacts, each with that part
/// of the mass. Then all contacts together move the body no further than it can go. If some particles cannot
/// yield, half of the body is for their contacts. Each of these may have to hold the body alone. Half is for
/// the attachments, which compute their own fraction (BodyAttachments).
struct Split {
  View<const uint32_t> grouped;
  View<const BodyProxy> bodies;
  View<const pbd::Vec4> position;
  ContactView contacts;
  View<const GroupCounts> counts{};  ///< by body, where ranks share the contacts

  MENISCUS_HD void operator()(uint32_t k) const {
    if (k >= contacts.total()) return;
    const uint32_t n = grouped[k];
    Contact& c = contacts.contacts[n];
    if (c.body >= bodies.count || is_attachment(c)) return;
    const BodyProxy& body = bodies[c.body];
    const float distance = plane_distance(c, position[contacts.particle[n]].xyz());
    const GroupCounts all = counts.count ? counts[c.body] : GroupCounts::of(body);
    c.arm = c.point + pbd::max(distance, c.radius) * c.normal - body.pose.position;
    c.body_inverse_mass += split_of(all, k < body.unyielding) * inverse_mass_at(body, c.arm, c.normal);
  }
};

/// The sum of what a body's contacts have done to particles; w is not used.
struct ContactSum {
  pbd::Vec4 push{0, 0, 0, 0};   ///< kg·m
  pbd::Vec4 twist{0, 0, 0, 0};  ///< kg·m², about the centre of mass

  MENISCUS_HD void add(Vec3 more_push, Vec3 more_twist) {
    push = pbd::with_w(push.xyz() + more_push, 0);
    twist = pbd::with_w(twist.xyz() + more_twist, 0);
  }
};

/// Sums one lane of one body.
struct SumLanes {
  View<const uint32_t> grouped;
  View<const BodyProxy> bodies;
  View<const Contact> contacts;
  View<ContactSum> partial;
  uint32_t lanes;

  /// Loads several contacts at once.
  MENISCUS_HD void operator()(uint32_t n) const {
    constexpr uint32_t batch = 4;
    const uint32_t first = bodies[n / lanes].first + n % lanes, end = bodies[n / lanes].end;
    ContactSum sum;
    for (uint32_t begin = first; begin < end; begin += batch * lanes) {
      Vec3 push[batch], arm[batch];
      MENISCUS_UNROLL
      for (uint32_t k = 0; k < batch; ++k) {
        const uint32_t at = begin + k * lanes;
        const Contact& c = contacts[grouped[at < end ? at : begin]];
        push[k] = multiplier_sum(c);
        arm[k] = c.arm;
      }
      MENISCUS_UNROLL
      for (uint32_t k = 0; k < batch; ++k) {
        if (begin + k * lanes < end) sum.add(push[k], cross(arm[k], push[k]));
      }
    }
    partial[n] = sum;
  }
};

inline constexpr uint32_t lane_batch = 8;  ///< a body's number of lanes is a multiple of this

/// Sums in the order of the lanes, a batch at a time, so that a GPU has that many loads in flight.
MENISCUS_HD inline ContactSum sum_of_lanes(View<const ContactSum> partial, uint32_t body, uint32_t lanes) {
  const View<const pbd::Vec4> values{&partial.data[body * lanes].push, 2 * lanes};
  ContactSum sum;
  for (uint32_t first = 0; first < lanes; first += lane_batch) {
    pbd::Vec4 next[2 * lane_batch];
    MENISCUS_UNROLL
    for (uint32_t k = 0; k < 2 * lane_batch; ++k) next[k] = pbd::load(values, 2 * first + k);
    MENISCUS_UNROLL
    for (uint32_t k = 0; k < lane_batch; ++k) sum.add(next[2 * k].xyz(), next[2 * k + 1].xyz());
  }
  return sum;
}

/// The displacement of a body by its contacts so far in the substep: m and rad.
struct ContactMotion {
  Vec3 shift, turn;
};

MENISCUS_HD inline ContactMotion motion_by(const BodyProxy& body, const ContactSum& sum) {
  const Vec3 twist = resisted_turn(body, sum.twist.xyz());
  return {-body.inverse_mass * resisted_push(body, sum.push.xyz()),
          -resisted_turn(body, inverse_inertia_times(body, twist))};
}

/// Moves the planes of a body's contacts to where all contacts have pushed the body. Each contact sums its
/// body's lanes itself, which costs less than a launch. The body's first contact stores the motion for the
/// next iteration.
struct Follow {
  View<const uint32_t> grouped;
  View<const BodyProxy> bodies;
  View<const ContactSum> partial;
  View<const ContactMotion> before;
  View<ContactMotion> after;
  ContactView contacts;
  uint32_t lanes;

  MENISCUS_HD void operator()(uint32_t k) const {
    const uint32_t n = grouped[k];
    const Contact c = contacts.contacts[n];  // loaded as a whole, together with the count
    if (k >= contacts.total() || c.body >= bodies.count) return;
    const BodyProxy& body = bodies[c.body];
    if (body.is_held) return;
    if (c.body_inverse_mass == 0 && k != body.first) return;
    const ContactMotion now = motion_by(body, sum_of_lanes(partial, c.body, lanes)), old = before[c.body];
    if (k == body.first) after[c.body] = now;
    const Vec3 step = now.shift - old.shift + cross(now.turn - old.turn, c.arm);
    contacts.contacts[n].point = c.point + step;
    contacts.contacts[n].surface_motion = c.surface_motion + step;
  }
};

/// Computes the substep's impulse on each body: that of its contacts, and what other sets load it with.
struct TakeImpulse {
  View<const ContactSum> partial;
  View<const RigidImpulse> loads;  ///< by body, or none
  View<RigidImpulse> impulses;
  uint32_t lanes;
  float inverse_dt;
  View<const ContactSum> zones{};  ///< by body: see BodyZones

  MENISCUS_HD void operator()(uint32_t b) const {
    ContactSum sum = sum_of_lanes(partial, b, lanes);
    if (zones.count) sum.add(zones[b].push.xyz(), zones[b].twist.xyz());
    const RigidImpulse load = loads.count ? loads[b] : RigidImpulse{{0, 0, 0}, {0, 0, 0}};
    impulses[b] = {load.linear - inverse_dt * sum.push.xyz(), load.angular - inverse_dt * sum.twist.xyz()};
  }
};

}  // namespace meniscus::collision::body_kernels
