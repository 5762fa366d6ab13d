// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Kernels that solve contacts in small steps, with soft contacts (Catto 2024).
#pragma once

#include "collision/rigid_contact/moving_bodies.h"
#include "pbd/math/tangents.h"

namespace meniscus::collision::rigid_contact_kernels {

struct SolverPoint {
  Vec3 arm_a, arm_b;                    ///< m, from the centres of mass, at the start of the step
  float distance;                       ///< m, then
  float speed;                          ///< m/s along the normal, then
  float mass, mass_along, mass_across;  ///< kg, effective
  float pressure, along, across;        ///< N·s in a small step
  float total;                          ///< N·s, of the pressure in the step so far
  uint32_t feature;
};

struct SolverContact {
  uint32_t contact;  ///< its place in the order of pairs
  uint32_t a, b;     ///< parts
  TwoBodies bodies;  ///< all bodies, also those that contacts do not move; no_index: fixed
  Vec3 normal;       ///< from b to a
  float friction, restitution;
  float push_speed;  ///< m/s, the most with which an overlap is removed
  float kept;        ///< of the change that an overlap asks for; softness
  uint32_t count;
  SolverPoint points[most_manifold_points];
};

/// Softness of a contact: a spring of the frequency ω, a fraction of the rate of small steps, with a damping
/// ratio of ζ (Catto 2024).
struct Softness {
  float removal;  ///< of an overlap, in a small step
  float kept;     ///< of an impulse's change; the rest is lost again
};

/// A body with another of `ratio` times its mass has as stiff a spring as two of the heavy one. With its own
/// it would sink into its load, and be thrown when that lets go.
MENISCUS_HD inline Softness softness(float ratio) {
  const float turn = 2 * 3.14159265f * rigid_contact_tuning::frequency;  // ω h
  const float stiff = turn * sqrtf(ratio), damped = 2 * rigid_contact_tuning::damping;
  return {turn / (damped + turn), 1 - 1 / (1 + stiff * (damped + stiff))};
}

struct SmallStep {
  float h;     ///< s
  float bias;  ///< 1/s: rate at which overlaps are removed
};

/// Makes what a contact needs to be solved, at its place in the order of colours.
struct Prepare {
  View<const uint32_t> order, contacts;
  View<const FoundContact> found;
  View<const ContactPart> parts;
  View<const ContactBody> start;
  View<const MovingBody> bodies;
  View<SolverContact> out;
  float h;

  MENISCUS_HD void operator()(uint32_t k) const {
    const FoundContact& c = found[contacts[order[k]]];
    const ContactPart &a = parts[c.a], &b = parts[c.b];
    SolverContact s;
    s.contact = order[k];
    s.a = c.a;
    s.b = c.b;
    s.bodies = {a.body, b.body};
    s.normal = c.manifold.normal;
    s.friction = a.friction * b.friction;
    s.restitution = a.restitution * b.restitution;
    s.push_speed = rigid_contact_tuning::push_rate * least_radius(a, b);
    s.count = c.manifold.count;
    const MovingBody body_a = body(a.body), body_b = body(b.body);
    s.kept = softness(ratio(body_a.inverse_mass, body_b.inverse_mass)).kept;
    const Tangents t(s.normal);
    for (uint32_t p = 0; p < s.count; ++p) {
      const ManifoldPoint& point = c.manifold.points[p];
      SolverPoint& to = s.points[p];
      to.arm_a = arm(a.body, point.position);
      to.arm_b = arm(b.body, point.position);
      to.distance = point.distance;
      to.speed = dot(speed(body_a, to.arm_a) - speed(body_b, to.arm_b), s.normal);
      to.mass = mass(body_a, body_b, to, s.normal);
      to.mass_along = mass(body_a, body_b, to, t.u);
      to.mass_across = mass(body_a, body_b, to, t.v);
      to.pressure = h * c.pressure[p];
      to.along = h * dot(c.friction[p], t.u);
      to.across = h * dot(c.friction[p], t.v);
      to.total = 0;
      to.feature = point.feature;
    }
    out[k] = s;
  }

  MENISCUS_HD MovingBody body(uint32_t i) const { return i == pbd::no_index ? fixed_body() : bodies[i]; }
  MENISCUS_HD Vec3 arm(uint32_t i, Vec3 p) const {
    return i == pbd::no_index ? Vec3{0, 0, 0} : p - start[i].pose.position;
  }
  MENISCUS_HD static Vec3 speed(const MovingBody& b, Vec3 arm) { return b.velocity + cross(b.angular, arm); }
  MENISCUS_HD static float mass(const MovingBody& a, const MovingBody& b, const SolverPoint& p, Vec3 d) {
    const Vec3 of_a = cross(p.arm_a, d), of_b = cross(p.arm_b, d);
    return 1 / (a.inverse_mass + b.inverse_mass + dot(of_a, a.inverse_inertia * of_a) +
                dot(of_b, b.inverse_inertia * of_b));
  }
  MENISCUS_HD static float ratio(float a, float b) {
    return a > 0 && b > 0 ? pbd::max(a, b) / pbd::min(a, b) : 1;
  }
  MENISCUS_HD static float least_radius(const ContactPart& a, const ContactPart& b) {
    if (is_unbounded(a.shape)) return bounding_radius(b.shape);
    if (is_unbounded(b.shape)) return bounding_radius(a.shape);
    return pbd::min(bounding_radius(a.shape), bounding_radius(b.shape));
  }
};

/// Runs `Solve` for the contacts of one colour.
template <class Solve>
struct OfColour {
  View<SolverContact> contacts;
  View<MovingBody> bodies;
  uint32_t first;
  Solve solve;

  MENISCUS_HD void operator()(uint32_t k) const { visit(contacts[first + k]); }

  MENISCUS_HD void visit(SolverContact& c) const {
    const bool has_a = c.bodies.a != pbd::no_index, has_b = c.bodies.b != pbd::no_index;
    MovingBody a = has_a ? bodies[c.bodies.a] : fixed_body();
    MovingBody b = has_b ? bodies[c.bodies.b] : fixed_body();
    solve(c, a, b);
    if (a.inverse_mass > 0) put(bodies[c.bodies.a], a);
    if (b.inverse_mass > 0) put(bodies[c.bodies.b], b);
  }
  MENISCUS_HD static void put(MovingBody& to, const MovingBody& from) {
    to.velocity = from.velocity;
    to.angular = from.angular;
    to.held = from.held;
    to.held_angular = from.held_angular;
  }
};

/// Runs `Visit`, such as OfColour, by groups, as a colour has few contacts and each takes long.
template <class Visit>
struct InGroups {
  static constexpr uint32_t group_threads = 32;
  struct Scratch {};

  Visit of_colour;
  uint32_t count;

  template <class Group>
  MENISCUS_HD void operator()(const Group& group, Scratch&, uint32_t n) const {
    const uint32_t first = group_threads * n, rest = count - first;
    Visit own = of_colour;
    own.first += first;
    group.for_each(rest < group_threads ? rest : group_threads, own);
  }
  static uint32_t groups(uint32_t count) { return (count + group_threads - 1) / group_threads; }
};

/// The same for several colours, one after the other, by one group. Those of the last one share bodies.
template <class Visit>
struct ColoursInOneGroup {
  static constexpr uint32_t group_threads = 128;
  struct Scratch {};

  Visit of_colour;
  View<const uint32_t> starts;
  uint32_t begin, end;

  template <class Group>
  MENISCUS_HD void operator()(const Group& group, Scratch&, uint32_t) const {
    Visit own = of_colour;
    for (uint32_t colour = begin; colour < end; ++colour) {
      own.first = starts[colour];
      const uint32_t count = starts[colour + 1] - own.first;
      if (colour != serial_colour) {
        group.for_each(count, own);
        continue;
      }
      group.for_each(1, [&](uint32_t) {
        for (uint32_t k = 0; k < count; ++k) own(k);
      });
    }
  }
};

/// Gives an impulse to both bodies.
MENISCUS_HD inline void push(MovingBody& a, MovingBody& b, const SolverPoint& p, Vec3 impulse) {
  a.velocity += a.inverse_mass * impulse;
  a.angular += a.inverse_inertia * cross(p.arm_a, impulse);
  b.velocity -= b.inverse_mass * impulse;
  b.angular -= b.inverse_inertia * cross(p.arm_b, impulse);
}
/// The same impulse in each small step from now on.
MENISCUS_HD inline void hold(MovingBody& a, MovingBody& b, const SolverPoint& p, Vec3 impulse) {
  a.held += impulse;
  a.held_angular += cross(p.arm_a, impulse);
  b.held -= impulse;
  b.held_angular -= cross(p.arm_b, impulse);
}
MENISCUS_HD inline Vec3 slip_of(const MovingBody& a, const MovingBody& b, const SolverPoint& p) {
  return Prepare::speed(a, p.arm_a) - Prepare::speed(b, p.arm_b);
}
/// m: how far apart the surfaces are now.
MENISCUS_HD inline float distance_of(const MovingBody& a, const MovingBody& b, const SolverPoint& p, Vec3 n) {
  const Vec3 way = a.moved + cross(a.turned, p.arm_a) - b.moved - cross(b.turned, p.arm_b);
  return p.distance + dot(way, n);
}

/// Lets bodies hold what their contacts start from.
struct WarmStart {
  MENISCUS_HD void operator()(SolverContact& c, MovingBody& a, MovingBody& b) const {
    const Tangents t(c.normal);
    for (uint32_t k = 0; k < c.count; ++k) {
      const SolverPoint& p = c.points[k];
      hold(a, b, p, p.pressure * c.normal + p.along * t.u + p.across * t.v);
    }
  }
};

/// Solves a contact once. With `removes` overlaps become a speed apart; without, that speed goes again.
struct SolveContact {
  SmallStep step;
  bool removes;
  bool is_last;  ///< in its small step

  MENISCUS_HD void operator()(SolverContact& c, MovingBody& a, MovingBody& b) const {
    const Tangents t(c.normal);
    for (uint32_t k = 0; k < c.count; ++k) {
      SolverPoint& p = c.points[k];
      press(c, p, a, b);
      rub(c, p, t, a, b);
      if (is_last) p.total += p.pressure;
    }
  }

  MENISCUS_HD void press(const SolverContact& c, SolverPoint& p, MovingBody& a, MovingBody& b) const {
    const float distance = distance_of(a, b, p, c.normal);
    float bias = 0, kept = 1;
    if (distance > 0) {
      bias = distance / step.h;
    } else if (removes) {
      bias = pbd::max(step.bias * distance, -c.push_speed);
      kept = c.kept;
    }
    const float speed = dot(slip_of(a, b, p), c.normal);
    const float change = -kept * p.mass * (speed + bias) - (1 - kept) * p.pressure;
    const float pressure = pbd::max(p.pressure + change, 0);
    const Vec3 impulse = (pressure - p.pressure) * c.normal;
    push(a, b, p, impulse);
    hold(a, b, p, impulse);
    p.pressure = pressure;
  }

  MENISCUS_HD static void rub(const SolverContact& c, SolverPoint& p, const Tangents& t, MovingBody& a,
                              MovingBody& b) {
    const Vec3 slip = slip_of(a, b, p);
    float along = p.along - p.mass_along * dot(slip, t.u);
    float across = p.across - p.mass_across * dot(slip, t.v);
    const float size = sqrtf(along * along + across * across), most = c.friction * p.pressure;
    if (size > most) {
      along *= most / size;
      across *= most / size;
    }
    const Vec3 impulse = (along - p.along) * t.u + (across - p.across) * t.v;
    push(a, b, p, impulse);
    hold(a, b, p, impulse);
    p.along = along;
    p.across = across;
  }
};

/// Contacts that have closed bounce, once a step.
struct Bounce {
  float least_speed;  ///< m/s

  MENISCUS_HD void operator()(SolverContact& c, MovingBody& a, MovingBody& b) const {
    if (c.restitution == 0) return;
    // The points of a face share one bounce, and a single round would turn the body.
    for (int round = 0; round < rigid_contact_tuning::bounce_rounds; ++round)
      for (uint32_t k = 0; k < c.count; ++k) bounce(c, c.points[k], a, b);
  }

  MENISCUS_HD void bounce(const SolverContact& c, SolverPoint& p, MovingBody& a, MovingBody& b) const {
    if (p.speed > -least_speed || p.total == 0) return;
    const float speed = dot(slip_of(a, b, p), c.normal);
    const float change = pbd::max(-p.mass * (speed + c.restitution * p.speed), -p.total);
    push(a, b, p, change * c.normal);
    p.total += change;
  }
};

/// Keeps what contacts start from in the next step, in the order of pairs.
struct KeepMemory {
  View<const SolverContact> contacts;
  View<const ContactBody> start;
  View<ContactMemory> memory;
  View<PartPair> touching;
  float h;

  MENISCUS_HD void operator()(uint32_t k) const {
    const SolverContact& c = contacts[k];
    const Tangents t(c.normal);
    ContactMemory m{c.b, c.count, c.normal, {}, {}, {}, {}, {}, {}};
    const bool has_a = c.bodies.a != pbd::no_index;  // one of both has a body
    const Vec3 centre = start[has_a ? c.bodies.a : c.bodies.b].pose.position;
    for (uint32_t p = 0; p < c.count; ++p) {
      m.feature[p] = c.points[p].feature;
      m.position[p] = centre + (has_a ? c.points[p].arm_a : c.points[p].arm_b);
      m.distance[p] = c.points[p].distance;
      m.impulse[p] = c.points[p].total;
      m.pressure[p] = c.points[p].pressure / h;
      m.friction[p] = (c.points[p].along / h) * t.u + (c.points[p].across / h) * t.v;
    }
    memory[c.contact] = m;
    touching[c.contact] = touching_parts(c.a, m);
  }
};

}  // namespace meniscus::collision::rigid_contact_kernels
