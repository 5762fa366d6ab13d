// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of BodyZones that move zones: the sums over their members, their common motion, and the
// impulses of bodies.
#pragma once

#include "collision/body/body_zones_find.h"

namespace meniscus::collision::zone_kernels {

/// Lets all vertices of a piece join, and finds the anchors of zones.
struct FindAnchors {
  Zones zones;
  ParticleView particles;
  uint32_t round;

  MENISCUS_HD void operator()(uint32_t n) const {
    if (n < zones.label.count && zones.crosses_body(round, n)) {
      const uint32_t name = zones.name(n);
      if (name != n) {
        pbd::atomic_max(zones.grown[name], pbd::atomic_load(zones.grown[n]));
        pbd::atomic_min(zones.anchor[name], pbd::atomic_load(zones.anchor[n]));
      }
    }
    if (n >= zones.zone_of.count || !zones.crosses_vertex(round, n)) return;
    const uint32_t i = particles.sorted + n, all = zones.piece_zone[pbd::phase_group(particles.phase[i])];
    if (all != no_index) zones.join(zones.zone_of[n], all);
    const uint32_t body = zones.zone_of[n];
    if (body != no_index && particles.position[i].w == 0)
      pbd::atomic_min(zones.anchor[zones.name(body)], zones.anchor_of(n));
  }
};

/// The sums over the members of a zone. Places are relative to the body that names it.
struct ZoneSum {
  float mass = 0;                  ///< kg
  Vec3 moment{0, 0, 0};            ///< kg·m
  Vec3 push{0, 0, 0};              ///< kg·m: mass times displacement
  Vec3 twist{0, 0, 0};             ///< kg·m²
  Sym3 inertia{0, 0, 0, 0, 0, 0};  ///< kg·m²

  MENISCUS_HD void add(float m, Vec3 at, Vec3 displacement) {
    mass += m;
    moment += m * at;
    push += m * displacement;
    twist += m * cross(at, displacement);
    inertia = inertia + m * inertia_of(at);
  }
  MENISCUS_HD void add(const ZoneSum& o) {
    mass += o.mass;
    moment += o.moment;
    push += o.push;
    twist += o.twist;
    inertia = inertia + o.inertia;
  }
  /// [r]ᵀ [r]
  MENISCUS_HD static Sym3 inertia_of(Vec3 r) {
    return {r.y * r.y + r.z * r.z,
            r.x * r.x + r.z * r.z,
            r.x * r.x + r.y * r.y,
            -r.x * r.y,
            -r.x * r.z,
            -r.y * r.z};
  }
};

/// Sums one lane of the vertices of a zone.
struct SumZones {
  Zones zones;
  ParticleView particles;
  View<const BodyProxy> bodies;
  View<ZoneSum> partial;
  uint32_t lanes, round;

  MENISCUS_HD void operator()(uint32_t n) const {
    const uint32_t b = n / lanes;
    if (!zones.crosses_body(round, b) || zones.grown[b] == 0 || zones.name(b) != b) return;
    ZoneSum sum;
    const uint32_t first = b / zones.bodies * zones.vertices;
    for (uint32_t v = first + n % lanes; v < first + zones.vertices; v += lanes) {
      const uint32_t body = zones.zone_of[v], i = particles.sorted + v;
      if (body == no_index || zones.name(body) != b) continue;
      const Vec4 x = particles.position[i];
      const Vec3 from = particles.previous[i].xyz();
      if (x.w > 0) sum.add(1 / x.w, from - bodies[b].start.position, x.xyz() - from);
    }
    partial[n] = sum;
  }
};

/// The common motion of the members of a zone: it has their linear momentum, and their angular momentum.
struct FindMotion {
  Zones zones;
  ParticleView particles;
  BodyState state;
  View<const ZoneSum> partial;
  uint32_t lanes, round;

  MENISCUS_HD void operator()(uint32_t b) const {
    if (!zones.crosses_body(round, b) || zones.grown[b] == 0 || zones.name(b) != b) return;
    const uint32_t anchor = zones.anchor[b];
    if (anchor < zones.label.count) {
      const Pose &from = state.bodies[anchor].start, &to = zones.pose[anchor];
      zones.motion[b] = {from.position, to.position - from.position, zones.turn[anchor]};
      return;
    }
    const ZoneSum sum = sum_of(b);
    if (anchor != no_index) {
      const uint32_t i = particles.sorted + anchor - zones.label.count;
      const Vec3 from = particles.previous[i].xyz(), shift = particles.position[i].xyz() - from;
      zones.motion[b] = {from, shift, {0, 0, 0}};
      particles.accumulated_delta[i] =
          pbd::shifted(particles.accumulated_delta[i], sum.push - sum.mass * shift);
      return;
    }
    const Vec3 centre = 1 / sum.mass * sum.moment, shift = 1 / sum.mass * sum.push;
    const Sym3 inertia = sum.inertia - sum.mass * ZoneSum::inertia_of(centre);
    const Vec3 twist = sum.twist - cross(centre, sum.push);
    const Vec3 turn = state.turns(b) ? inverse(inertia) * twist : zones.turn[b];
    zones.motion[b] = {state.bodies[b].start.position + centre, shift, turn};
  }

 private:
  MENISCUS_HD ZoneSum sum_of(uint32_t b) const {
    ZoneSum sum;
    for (uint32_t lane = 0; lane < lanes; ++lane) sum.add(partial[b * lanes + lane]);
    const uint32_t first = b / zones.bodies * zones.bodies;
    for (uint32_t other = first; other < first + zones.bodies; ++other) {
      const BodyProxy& body = state.bodies[other];
      if (body.inverse_mass == 0 || zones.name(other) != b) continue;
      const Vec3 from = body.start.position, displacement = zones.pose[other].position - from;
      sum.add(1 / body.inverse_mass, from - state.bodies[b].start.position, displacement);
      if (!state.turns(other)) continue;
      const Vec3 principal = state.inertia(other);
      sum.twist += state.at_start(other, zones.turn[other], principal);
      sum.inertia = sum.inertia + turned(rotation_matrix(body.start.rotation),
                                         Sym3{principal.x, principal.y, principal.z, 0, 0, 0});
    }
    return sum;
  }
};

/// Moves bodies and vertices with their zones.
struct Move {
  Zones zones;
  ParticleView particles;
  View<const BodyProxy> bodies;
  uint32_t round;

  MENISCUS_HD void operator()(uint32_t n) const {
    if (n < zones.label.count && zones.crosses_body(round, n)) move_body(n);
    if (n < zones.zone_of.count && zones.crosses_vertex(round, n)) move_vertex(n);
  }

 private:
  MENISCUS_HD void move_body(uint32_t b) const {
    if (!zones.is_zone(b) || bodies[b].inverse_mass == 0) return;
    const ZoneMotion motion = zones.motion[zones.name(b)];
    zones.pose[b] = motion.applied(bodies[b].start);
    zones.turn[b] = motion.turn;
  }
  /// Computed with displacements: the rounding of positions would lose momentum.
  MENISCUS_HD void move_vertex(uint32_t v) const {
    const uint32_t body = zones.zone_of[v], i = particles.sorted + v;
    const Vec4 x = particles.position[i];
    if (body == no_index || x.w == 0) return;
    const Vec3 from = particles.previous[i].xyz();
    const Vec3 displacement = zones.motion[zones.name(body)].displacement(from);
    particles.position[i] = pbd::with_w(from + displacement, x.w);
    particles.accumulated_delta[i] =
        pbd::shifted(particles.accumulated_delta[i], displacement - (x.xyz() - from));
  }
};

/// Gives each body of a zone the impulse with which it moves as the zone does.
struct Give {
  Zones zones;
  BodyState state;
  View<ContactSum> impulses;  ///< by body

  MENISCUS_HD void operator()(uint32_t b) const {
    const BodyProxy& body = state.bodies[b];
    if (!zones.crosses_body(0, b) || body.inverse_mass == 0 || !zones.is_zone(b)) return;
    const ContactSum sum = state.sum(b);
    const Vec3 shift = zones.pose[b].position - body.start.position;
    const Vec3 push = 1 / body.inverse_mass * (state.shift(b, sum) - shift);
    const Vec3 turn = state.turn(b, sum) - zones.turn[b];
    const Vec3 twist = state.turns(b) ? state.at_start(b, turn, state.inertia(b)) : Vec3{0, 0, 0};
    impulses[b].add(push, twist);
  }
};

/// Moves the planes of contacts with the bodies of zones.
struct Follow {
  Zones zones;
  View<const BodyProxy> bodies;
  View<const body_kernels::ContactMotion> before;
  pbd::ContactView contacts;

  MENISCUS_HD void operator()(uint32_t n) const {
    if (n >= contacts.total()) return;
    pbd::Contact& c = contacts.contacts[n];
    if (c.body >= bodies.count || !zones.crosses_body(0, c.body) || !zones.is_zone(c.body) ||
        bodies[c.body].inverse_mass == 0)
      return;
    const BodyProxy& body = bodies[c.body];
    const Vec3 arm = rotate(conjugate(body.pose.rotation), c.arm);
    const body_kernels::ContactMotion old = before[c.body];
    const Vec3 step = to_world(zones.pose[c.body], arm) - (body.pose.position + c.arm) -
                      (old.shift + cross(old.turn, c.arm));
    c.point += step;
    c.surface_motion += step;
  }
};

}  // namespace meniscus::collision::zone_kernels
