// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What sheets and fluid do to one another.
//
// A sheet is light: a particle may weigh hundreds of times what a vertex does. Solved by turns, contacts
// would move the vertices, and cloth pull them back through the particles, with hardly an impulse getting
// across. So what presses against a sheet is one with it: a vertex with the weights b_c in the
// touches c is as heavy as
//
//   m + Σ_c b_c m_c
//
// for whatever moves it, and then moves the particles by Σ_v b_v Δx_v: the impulse is shared out as by a
// lumped mass matrix, and momentum kept. Beside the sheet, a particle moves alone. For vertex and particles
// to be one they must start as one: at the substep's start they share their momentum, as after an inelastic
// impact, or what a light vertex does alone would be done to heavy particles.
#pragma once

#include "collision/fluid_cloth/cloth_surface.h"
#include "pbd/contacts.h"

namespace meniscus::collision::fluid_cloth_kernels {

/// Works on one vertex: of coarse cloth each has thousands of touches.
using VertexTeam = pbd::Team<32>;

/// The vertices of sheets, and what is entered with them. A team asks.
struct LoadedVertices {
  View<const uint32_t> start, entries;  // see EnterTouches
  View<const FluidClothContact> touches;
  View<const float> self_weight;  // 1/kg
  float unit;                     // kg·m or kg, of the integers that sums run in; a power of 2

  MENISCUS_HD bool any(uint32_t v) const { return start[v] != start[v + 1]; }

  /// Sums term(touch, weight) in integers, whose sum is the same in any order.
  template <class Term>
  MENISCUS_HD float sum(uint32_t v, const Term& term) const {
    int64_t total = 0;
    for_each(v, [&](const FluidClothContact& t, float weight) { total += llrintf(term(t, weight) / unit); });
    return unit * static_cast<float>(VertexTeam::sum(total));
  }
  /// Of the pending impulses, kg·m, which act against the sheet.
  MENISCUS_HD Vec3 pending(uint32_t v) const {
    int64_t x = 0, y = 0, z = 0;
    for_each(v, [&](const FluidClothContact& t, float weight) {
      const Vec3 push = (-weight / unit) * t.pending;
      x += llrintf(push.x);
      y += llrintf(push.y);
      z += llrintf(push.z);
    });
    return {unit * static_cast<float>(VertexTeam::sum(x)), unit * static_cast<float>(VertexTeam::sum(y)),
            unit * static_cast<float>(VertexTeam::sum(z))};
  }

 private:
  template <class Visit>
  MENISCUS_HD void for_each(uint32_t v, const Visit& visit) const {
    const uint32_t end = start[v + 1] < entries.count ? start[v + 1] : entries.count;
    for (uint32_t e = start[v] + VertexTeam::rank(); e < end; e += VertexTeam::count()) {
      const FluidClothContact& t = touches[entries[e] >> 5];
      visit(t, t.weight[entries[e] & 31]);
    }
  }
};

/// What happens at the touches of one particle, between the sheets and the contacts. A team is at work on it:
/// all of its threads take part in means over vertices, and the first one writes.
struct AtTouches {
  NearList near;
  View<pbd::Contact> contacts;
  View<Vec4> position, accumulated_delta;
  View<const Vec4> previous;
  View<const pbd::Phase> phase;
  uint32_t first_vertex;
  Vec3 fall;  ///< m: what gravity alone moves by in the substep

  MENISCUS_HD FluidClothContact& touch(uint32_t k, uint32_t n) const {
    return near.touches[most_touches * k + n];
  }
  /// Whether there is a contact, and there was room for it.
  MENISCUS_HD bool is_live(const FluidClothContact& t) const {
    return is_used(t) && t.contact < contacts.count;
  }
  MENISCUS_HD bool is_pressing(uint32_t i) const { return (phase[i] & pbd::phase_pressing) != 0; }

  /// m: how far the sheet has been moved in the substep. What nothing moves notes impulses in `moved`.
  MENISCUS_HD Vec3 motion_of_cloth(const FluidClothContact& t) const {
    return t.mean([&](uint32_t v) {
      return position[first_vertex + v].w > 0 ? accumulated_delta[first_vertex + v].xyz() : Vec3{0, 0, 0};
    });
  }

  /// Takes the contact to where the sheet is; returns to the first thread how far.
  MENISCUS_HD Vec3 follow_cloth(FluidClothContact& t) const {
    const Vec3 displacement = motion_of_cloth(t);
    if (!TouchTeam::leads()) return {0, 0, 0};
    const Vec3 step = displacement - t.followed;
    t.followed = displacement;
    pbd::Contact& c = contacts[t.contact];
    c.point += step;
    c.surface_motion += step;
    return step;
  }

  /// And the share of the particle that it carries.
  MENISCUS_HD Vec3 follow(FluidClothContact& t) const {
    const Vec3 step = follow_cloth(t);
    if (!TouchTeam::leads()) return step;
    const Vec3 push = t.carried * step;
    contacts[t.contact].density_push += push;
    t.given += push;
    return step;
  }

  /// Moves particle i as the sheets that carry it have moved.
  MENISCUS_HD void carry(uint32_t k, uint32_t i) const {
    Vec3 step{0, 0, 0};
    for (uint32_t n = 0; n < most_touches; ++n) {
      FluidClothContact& t = touch(k, n);
      if (is_live(t)) step += t.carried_fraction * follow(t);
    }
    if (TouchTeam::leads()) move(i, step);
  }
  MENISCUS_HD void move(uint32_t i, Vec3 step) const {
    position[i] = pbd::shifted(position[i], step);
    accumulated_delta[i] = pbd::shifted(accumulated_delta[i], step);
  }

  /// Notes what the contacts have pushed since the last time.
  MENISCUS_HD void note_pushes(uint32_t k) const {
    for (uint32_t n = 0; n < most_touches; ++n) {
      FluidClothContact& t = touch(k, n);
      if (!is_live(t)) continue;
      const Vec3 sum = multiplier_sum(contacts[t.contact]);
      t.pending = sum - t.given;
      t.given = sum;
    }
  }

  /// Whether particle i bears on the sheet.
  MENISCUS_HD bool presses(const FluidClothContact& t, uint32_t i) const {
    if (!is_live(t)) return false;
    const pbd::Contact& c = contacts[t.contact];
    return bears(c.normal, c.normal_multiplier + dot(c.density_push, c.normal), i);
  }
  /// Whether it is predicted to, or as good as that: what would stop just before the sheet is pressed against
  /// it by the layers behind.
  MENISCUS_HD bool comes_to_press(const FluidClothContact& t, uint32_t i) const {
    if (!is_live(t)) return false;
    const pbd::Contact& c = contacts[t.contact];
    const Vec3 x = position[i].xyz(), displacement = x - previous[i].xyz() - c.surface_motion;
    return dot(x - c.point, c.normal) < 1.1f * c.radius &&
           bears(c.normal, -dot(displacement, c.normal) / position[i].w, i);
  }

 private:
  /// Whether an impulse `normal`, kg·m, holds particle i. What presses with less than a quarter of what its
  /// weight would drag with must run down a sheet that stands upright: stuck to it, the topmost layer around
  /// a hull weighs on it. Let go of sooner, it threw taut light sheets about.
  MENISCUS_HD bool bears(Vec3 direction, float normal, uint32_t i) const {
    const Vec3 weight = fall / position[i].w, drag = weight - dot(weight, direction) * direction;
    return normal > 0 && length(drag) <= 4 * normal;
  }
};

/// Before anything is solved: what pressed at the last substep's end is carried, and what is about to, and
/// brings in its predicted way. Met with the mass of a lone vertex, an impact would throw it further than its
/// edges are long.
struct StartTouches {
  AtTouches at;

  MENISCUS_HD void operator()(uint32_t k) const {
    if (k >= at.near.count()) return;
    const uint32_t i = at.near.particle[k];
    int carriers = 0;
    bool carried = at.is_pressing(i);
    for (uint32_t n = 0; n < most_touches; ++n) {
      carriers += at.is_live(at.touch(k, n));
      carried |= at.comes_to_press(at.touch(k, n), i);
    }
    const Vec3 displacement = at.position[i].xyz() - at.previous[i].xyz();
    for (uint32_t n = 0; n < most_touches; ++n) {
      FluidClothContact& t = at.touch(k, n);
      const bool live = at.is_live(t);
      // The contact was found where that has taken the sheet already.
      const Vec3 followed = live ? at.motion_of_cloth(t) : Vec3{0, 0, 0};
      if (!TouchTeam::leads()) continue;
      t.followed = followed;
      t.carried_fraction = carried && live ? 1.0f / static_cast<float>(carriers) : 0.0f;
      t.carried = t.carried_fraction / at.position[i].w;
      t.pending = -t.carried * displacement;
    }
  }
};

/// Vertices and what they carry share their momentum.
struct ShareMomentum {
  LoadedVertices vertices;
  View<Vec4> position, accumulated_delta;  // by vertex
  View<const Vec4> previous;               // by vertex
  View<Vec4> taken;  // by vertex, m: what it took of the motion of each of its particles

  MENISCUS_HD void operator()(uint32_t v) const {
    if (!vertices.any(v)) return;
    const float self = vertices.self_weight[v];
    const float carried = vertices.sum(v, [](const FluidClothContact& t, float w) { return w * t.carried; });
    const Vec3 pending = vertices.pending(v);
    if (!VertexTeam::leads()) return;
    taken[v] = {0, 0, 0, 0};
    if (self == 0 || !(carried > 0)) return;
    const Vec4 x = position[v];
    const Vec3 displacement = x.xyz() - previous[v].xyz();
    const float weight = self / (1 + self * carried);
    const Vec3 step = weight * (pending - carried * displacement);
    taken[v] = pbd::with_w(step / (self * carried), 0);
    position[v] = pbd::with_w(x.xyz() + step, weight);
    accumulated_delta[v] = pbd::shifted(accumulated_delta[v], step);
  }
};

/// The particles' part of that; from here on contacts follow the sheets.
struct GiveMomentum {
  AtTouches at;
  View<const Vec4> taken;  // by vertex

  MENISCUS_HD void operator()(uint32_t k) const {
    if (k >= at.near.count()) return;
    Vec3 step{0, 0, 0};
    for (uint32_t n = 0; n < most_touches; ++n) {
      FluidClothContact& t = at.touch(k, n);
      if (TouchTeam::leads()) t.pending = {0, 0, 0};
      if (!at.is_live(t)) continue;
      const Vec3 took = t.mean([&](uint32_t v) { return taken[v].xyz(); });
      at.follow_cloth(t);
      if (!TouchTeam::leads()) continue;
      step += -t.carried_fraction * took;
      pbd::Contact& c = at.contacts[t.contact];
      c.density_push += -t.carried * took;
      t.given += -t.carried * took;
    }
    if (TouchTeam::leads()) at.move(at.near.particle[k], step);
  }
};

/// Moves what the sheets carry, and the contacts; if `weighs`, notes what the sheets are to get back.
struct FollowCloth {
  AtTouches at;
  bool weighs;

  MENISCUS_HD void operator()(uint32_t k) const {
    if (k >= at.near.count()) return;
    at.carry(k, at.near.particle[k]);
    if (weighs && TouchTeam::leads()) at.note_pushes(k);
  }
};

/// Pushes the vertices back. What nothing moves notes it.
struct PushVertices {
  LoadedVertices vertices;
  View<Vec4> position, accumulated_delta;  // by vertex

  MENISCUS_HD void operator()(uint32_t v) const {
    if (!vertices.any(v)) return;
    const Vec3 push = vertices.pending(v);
    if (!VertexTeam::leads()) return;
    const Vec4 x = position[v];
    position[v] = pbd::with_w(x.xyz() + x.w * push, x.w);
    accumulated_delta[v] = pbd::shifted(accumulated_delta[v], (x.w > 0 ? x.w : 1) * push);
  }
};

/// Gives the vertices their own masses back, and notes what they were with their loads.
struct Unload {
  LoadedVertices vertices;
  View<Vec4> position;  // by vertex
  View<float> loaded;   // by vertex, 1/kg

  MENISCUS_HD void operator()(uint32_t v) const {
    if (!vertices.any(v)) return;
    loaded[v] = position[v].w;
    position[v].w = vertices.self_weight[v];
  }
};

/// How sheets give way to the density constraint, as the bodies of other contacts do (fluid/density_wall_
/// kernels.h): each vertex is split among its touches.
struct NoteGive {
  NearList near;
  LoadedVertices vertices;
  View<const Vec4> position;  // by vertex
  View<pbd::Contact> contacts;

  MENISCUS_HD void operator()(uint32_t n) const {
    if (n >= most_touches * near.count()) return;
    const FluidClothContact& t = near.touches[n];
    if (!is_used(t) || t.contact >= contacts.count) return;
    float give = 0;
    for (uint32_t k = TouchTeam::rank(); k < t.vertices; k += TouchTeam::count()) {
      const uint32_t v = t.vertex[k];
      const auto touches = static_cast<float>(vertices.start[v + 1] - vertices.start[v]);
      give += t.weight[k] * t.weight[k] * touches * position[v].w;
    }
    give = TouchTeam::sum(give);
    if (TouchTeam::leads()) contacts[t.contact].body_inverse_mass = give;
  }
};

/// Notes what the contacts have changed velocities by since the positions were done (restitution).
struct WeighVelocities {
  AtTouches at;

  MENISCUS_HD void operator()(uint32_t k) const {
    if (k < at.near.count()) at.note_pushes(k);
  }
};

/// Gives it to the vertices.
struct LoadVelocities {
  LoadedVertices vertices;
  View<const float> loaded;  // by vertex, 1/kg
  View<Vec4> velocity;       // by vertex
  View<Vec4> change;         // by vertex, m/s
  float inverse_dt;

  MENISCUS_HD void operator()(uint32_t v) const {
    if (!vertices.any(v)) return;
    const Vec3 step = (loaded[v] * inverse_dt) * vertices.pending(v);
    if (!VertexTeam::leads()) return;
    change[v] = pbd::with_w(step, 0);
    velocity[v] = pbd::with_w(velocity[v].xyz() + step, velocity[v].w);
  }
};

/// Speeds up what the sheets carry, and notes who presses, for the next substep.
struct CarryVelocities {
  AtTouches at;
  View<const Vec4> change;  // by vertex
  View<Vec4> velocity;
  View<pbd::Phase> phase;

  MENISCUS_HD void operator()(uint32_t k) const {
    if (k >= at.near.count()) return;
    const uint32_t i = at.near.particle[k];
    Vec3 step{0, 0, 0};
    bool presses = false;
    for (uint32_t n = 0; n < most_touches; ++n) {
      const FluidClothContact& t = at.touch(k, n);
      presses |= at.presses(t, i);
      if (!is_used(t) || t.carried_fraction == 0) continue;
      step += t.carried_fraction * t.mean([&](uint32_t v) { return change[v].xyz(); });
    }
    if (!TouchTeam::leads()) return;
    velocity[i] = pbd::with_w(velocity[i].xyz() + step, velocity[i].w);
    phase[i] = presses ? phase[i] | pbd::phase_pressing : phase[i] & ~pbd::phase_pressing;
  }
};

}  // namespace meniscus::collision::fluid_cloth_kernels
