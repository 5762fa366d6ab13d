// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Contacts among solids within the iterations of particles: what they bear of the particles' pushes.
#pragma once

#include "collision/rigid_contact/bearing.h"
#include "collision/rigid_contact/solve_kernels.h"

namespace meniscus::collision::rigid_contact_kernels {

struct BearingPoint {
  Vec3 arm_a, arm_b;             ///< m
  float gap, along, across;      ///< m: how far apart without particles, and how far it slips
  float pressure, rub_u, rub_v;  ///< kg·m of the substep: what it bears
};

/// A contact as the iterations solve it, in the order of colours.
struct Bearing {
  TwoBodies bodies;
  Vec3 normal;
  float friction;
  uint32_t count;
  BearingPoint points[most_manifold_points];
};

/// Starts from the solution without particles. Forces over the substep are multiples of dt².
struct StartBearing {
  View<const SolverContact> contacts;
  View<const MovingBody> bodies;
  View<Bearing> out;
  float dt;                ///< s, of the substep
  float step, small_step;  ///< s, of the solution

  MENISCUS_HD void operator()(uint32_t k) const {
    const SolverContact& c = contacts[k];
    const MovingBody a = body(c.bodies.a), b = body(c.bodies.b);
    const Tangents t(c.normal);
    Bearing to{c.bodies, c.normal, c.friction, c.count, {}};
    for (uint32_t p = 0; p < c.count; ++p) {
      const SolverPoint& from = c.points[p];
      const Vec3 slip = dt * slip_of(a, b, from);
      const float held = dt * dt / small_step;
      to.points[p] = {from.arm_a,        from.arm_b,        pbd::max(0.0f, distance_of(a, b, from, c.normal)),
                      dot(slip, t.u),    dot(slip, t.v),    dt * dt / step * from.total,
                      held * from.along, held * from.across};
    }
    out[k] = to;
  }
  MENISCUS_HD MovingBody body(uint32_t i) const { return i == pbd::no_index ? fixed_body() : bodies[i]; }
};

/// Solves the contacts of a colour once.
struct Bear {
  View<Bearing> contacts;
  View<HeldBody> bodies;
  uint32_t first;

  MENISCUS_HD void operator()(uint32_t k) const { visit(contacts[first + k]); }

  MENISCUS_HD void visit(Bearing& c) const {
    HeldBody a = body(c.bodies.a), b = body(c.bodies.b);
    if (!a.moves && !b.moves) return;
    const Tangents t(c.normal);
    for (uint32_t k = 0; k < c.count; ++k) {
      BearingPoint& p = c.points[k];
      const float most = p.pressure + closing(a, b, p, c.normal, p.gap);
      push(a, b, p, (pbd::max(most, 0.0f) - p.pressure) * c.normal);
      p.pressure = pbd::max(most, 0.0f);
      rub(c, p, t, a, b);
    }
    if (a.moves) bodies[c.bodies.a] = a;
    if (b.moves) bodies[c.bodies.b] = b;
  }

  MENISCUS_HD HeldBody body(uint32_t i) const { return i == pbd::no_index ? HeldBody{} : bodies[i]; }

  /// kg·m: what stops the motion along n that exceeds −gap.
  MENISCUS_HD static float closing(const HeldBody& a, const HeldBody& b, const BearingPoint& p, Vec3 n,
                                   float gap) {
    const Vec3 way = motion_at(a.motion, p.arm_a) - motion_at(b.motion, p.arm_b);
    return -(gap + dot(way, n)) / (give_at(a, p.arm_a, n) + give_at(b, p.arm_b, n));
  }
  MENISCUS_HD static void rub(const Bearing& c, BearingPoint& p, const Tangents& t, HeldBody& a,
                              HeldBody& b) {
    float u = p.rub_u + closing(a, b, p, t.u, p.along), v = p.rub_v + closing(a, b, p, t.v, p.across);
    const float size = sqrtf(u * u + v * v), most = c.friction * p.pressure;
    if (size > most) {
      u *= most / size;
      v *= most / size;
    }
    push(a, b, p, (u - p.rub_u) * t.u + (v - p.rub_v) * t.v);
    p.rub_u = u;
    p.rub_v = v;
  }
  MENISCUS_HD static void push(HeldBody& a, HeldBody& b, const BearingPoint& p, Vec3 change) {
    bear(a, p.arm_a, change);
    bear(b, p.arm_b, -change);
  }
  MENISCUS_HD static void bear(HeldBody& body, Vec3 arm, Vec3 change) {
    if (!body.moves) return;
    const Six by{change, cross(arm, change)};
    body.motion += body.give * by;
    body.borne += by;
  }
};

/// Gives the forces that were found to the step that follows, which starts from them.
struct StoreBearing {
  View<const Bearing> bearing;
  View<const uint32_t> order, contacts;
  View<FoundContact> found;
  float dt;  ///< s, of the substep

  MENISCUS_HD void operator()(uint32_t k) const {
    const Bearing& from = bearing[k];
    const Tangents t(from.normal);
    FoundContact& to = found[contacts[order[k]]];
    for (uint32_t p = 0; p < from.count; ++p) {
      to.pressure[p] = from.points[p].pressure / (dt * dt);
      to.friction[p] = (from.points[p].rub_u / (dt * dt)) * t.u + (from.points[p].rub_v / (dt * dt)) * t.v;
    }
  }
};

}  // namespace meniscus::collision::rigid_contact_kernels
