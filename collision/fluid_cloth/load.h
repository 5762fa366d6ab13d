// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The two-way coupling of cloth and fluid.
//
// Cloth is light: a particle may have hundreds of times the mass of a vertex. If the two were solved in turn,
// contacts would move the vertices, and cloth would pull them back through the particles. Hardly any impulse
// would be transferred. So the particles that press on cloth move as one with it. For whatever moves it, a
// vertex with the weights b_c in the contacts c has the mass
//
//   m + Σ_c b_c m_c.
//
// The particles then move by Σ_v b_v Δx_v. So the impulse is distributed as by a lumped mass matrix, and
// momentum is conserved. Relative to the cloth, a particle moves alone. A vertex and its particles must start
// with one velocity. So they share their momentum at the substep's start, as after an inelastic impact.
// Otherwise the motion of a light vertex alone would be imposed on heavy particles.
#pragma once

#include "collision/fluid_cloth/cloth_surface.h"
#include "collision/fluid_cloth/tuning.h"
#include "pbd/contacts.h"
#include "pbd/math/units.h"
#include "pbd/worlds.h"

namespace meniscus::collision::fluid_cloth_kernels {

/// Works on one vertex: a vertex of coarse cloth has thousands of contacts.
using VertexTeam = pbd::Team<32>;

/// The vertices of cloth with their entries. A team reads them.
struct LoadedVertices {
  View<const uint32_t> start, entries;  // see EnterTouches
  View<const FluidClothContact> touches;
  View<const float> self_weight;  // 1/kg
  float unit;                     // kg·m or kg, unit of the integers in which sums run; a power of 2

  MENISCUS_HD bool any(uint32_t v) const { return start[v] != start[v + 1]; }

  /// Sums term(touch, weight) in integers, so the sum is the same in any order.
  template <class Term>
  MENISCUS_HD float sum(uint32_t v, const Term& term) const {
    int64_t total = 0;
    for_each(v, [&](const FluidClothContact& t, float weight) {
      total += pbd::whole_units(term(t, weight) / unit);
    });
    return unit * static_cast<float>(VertexTeam::sum(total));
  }
  /// The sum of the pending impulses, kg·m, which act against the cloth.
  MENISCUS_HD Vec3 pending(uint32_t v) const {
    int64_t x = 0, y = 0, z = 0;
    for_each(v, [&](const FluidClothContact& t, float weight) {
      const Vec3 push = (-weight / unit) * t.pending;
      x += pbd::whole_units(push.x);
      y += pbd::whole_units(push.y);
      z += pbd::whole_units(push.z);
    });
    return {unit * static_cast<float>(VertexTeam::sum(x)), unit * static_cast<float>(VertexTeam::sum(y)),
            unit * static_cast<float>(VertexTeam::sum(z))};
  }
  /// Calls visit(touch, weight) for the team's share of the contacts of vertex v.
  template <class Visit>
  MENISCUS_HD void for_each(uint32_t v, const Visit& visit) const {
    const uint32_t end = start[v + 1] < entries.count ? start[v + 1] : entries.count;
    for (uint32_t e = start[v] + VertexTeam::rank(); e < end; e += VertexTeam::count()) {
      const FluidClothContact& t = touches[entries[e] >> 5];
      visit(t, t.weight[entries[e] & 31]);
    }
  }
};

/// Operations on the contacts of one particle, between the cloth and the contacts. A team works on it: all of
/// its threads take part in means over vertices, and the first one writes.
struct AtTouches {
  NearList near;
  View<pbd::Contact> contacts;
  View<Vec4> position, accumulated_delta;
  View<const Vec4> previous;
  View<const pbd::Phase> phase;
  uint32_t first_vertex;
  Vec3 gravity_step;              ///< m: the displacement by gravity alone in the substep
  pbd::WorldGravities gravities;  ///< in place of gravity_step, where worlds have their own
  float dt2;                      ///< s², for them

  MENISCUS_HD FluidClothContact& touch(uint32_t k, uint32_t n) const {
    return near.touches[most_touches * k + n];
  }
  /// Whether there is a contact, and there was room for it.
  MENISCUS_HD bool is_live(const FluidClothContact& t) const {
    return is_used(t) && t.contact < contacts.count;
  }
  MENISCUS_HD bool is_pressing(uint32_t i) const { return (phase[i] & pbd::phase_pressing) != 0; }

  /// The displacement of the cloth in the substep, m. Immovable vertices store impulses in
  /// `accumulated_delta` instead.
  MENISCUS_HD Vec3 motion_of_cloth(const FluidClothContact& t) const {
    return t.mean([&](uint32_t v) {
      return position[first_vertex + v].w > 0 ? accumulated_delta[first_vertex + v].xyz() : Vec3{0, 0, 0};
    });
  }

  /// Moves the contact with the cloth, and returns its step to the first thread.
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

  /// The same, with the fraction of the particle that the cloth carries.
  MENISCUS_HD Vec3 follow(FluidClothContact& t) const {
    const Vec3 step = follow_cloth(t);
    if (!TouchTeam::leads()) return step;
    const Vec3 push = t.carried * step;
    contacts[t.contact].density_push += push;
    t.given += push;
    return step;
  }

  /// Moves particle i as the cloth that carries it has moved.
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

  /// Stores what the contacts have pushed since the last call.
  MENISCUS_HD void note_pushes(uint32_t k) const {
    for (uint32_t n = 0; n < most_touches; ++n) {
      FluidClothContact& t = touch(k, n);
      if (!is_live(t)) continue;
      const Vec3 sum = multiplier_sum(contacts[t.contact]);
      t.pending = sum - t.given;
      t.given = sum;
    }
  }

  /// Whether particle i presses on the cloth.
  MENISCUS_HD bool presses(const FluidClothContact& t, uint32_t i) const {
    if (!is_live(t)) return false;
    const pbd::Contact& c = contacts[t.contact];
    return supports(c.normal, c.normal_multiplier + dot(c.density_push, c.normal), i);
  }
  /// Whether it is predicted to press, or nearly so. A particle that would stop just before the cloth is
  /// pressed against it by the layers behind.
  MENISCUS_HD bool comes_to_press(const FluidClothContact& t, uint32_t i) const {
    if (!is_live(t)) return false;
    const pbd::Contact& c = contacts[t.contact];
    const Vec3 x = position[i].xyz(), displacement = x - previous[i].xyz() - c.surface_motion;
    return dot(x - c.point, c.normal) < fluid_cloth_tuning::about_to_press * c.radius &&
           supports(c.normal, -dot(displacement, c.normal) / position[i].w, i);
  }

 private:
  /// Whether an impulse `normal`, kg·m, is enough to carry particle i, by the tangential component of its
  /// weight. A particle with less must run down vertical cloth. If it stuck, the topmost layer around a hull
  /// would weigh on the hull.
  MENISCUS_HD bool supports(Vec3 direction, float normal, uint32_t i) const {
    const Vec3 step = gravities.gravity.count ? dt2 * gravities.of(i, {0, 0, 0}) : gravity_step;
    const Vec3 weight = step / position[i].w, drag = weight - dot(weight, direction) * direction;
    return normal > 0 && length(drag) <= fluid_cloth_tuning::most_drag * normal;
  }
};

/// Runs before anything is solved. Carried are the particles that pressed at the last substep's end and those
/// that are about to press. They bring in their predicted displacement. Met with the mass of a lone vertex,
/// an impact would move it further than its edges are long.
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
      // The contact was found where this displacement has already moved the cloth.
      const Vec3 followed = live ? at.motion_of_cloth(t) : Vec3{0, 0, 0};
      if (!TouchTeam::leads()) continue;
      t.followed = followed;
      t.carried_fraction = carried && live ? 1.0f / static_cast<float>(carriers) : 0.0f;
      t.carried = t.carried_fraction / at.position[i].w;
      t.pending = -t.carried * displacement;
    }
  }
};

/// Vertices and the particles that they carry share their momentum.
struct ShareMomentum {
  LoadedVertices vertices;
  View<Vec4> position, accumulated_delta;  // by vertex
  View<const Vec4> previous;               // by vertex
  View<Vec4> taken;  // by vertex, m: what it took from the displacement of each of its particles

  MENISCUS_HD void operator()(uint32_t v) const {
    if (!vertices.any(v)) return;
    const float self = position[v].w;
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

/// Applies the same to the particles. From here on contacts follow the cloth.
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

/// Moves the carried particles and the contacts with the cloth. If `weighs`, stores the impulses that the
/// vertices get next.
struct FollowCloth {
  AtTouches at;
  bool weighs;

  MENISCUS_HD void operator()(uint32_t k) const {
    if (k >= at.near.count()) return;
    at.carry(k, at.near.particle[k]);
    if (weighs && TouchTeam::leads()) at.note_pushes(k);
  }
};

/// Applies the pending impulses to the vertices. An immovable vertex stores the impulse.
struct PushVertices {
  LoadedVertices vertices;
  View<Vec4> position, accumulated_delta;  // by vertex

  MENISCUS_HD void operator()(uint32_t v) const {
    if (!vertices.any(v)) return;
    const Vec3 push = vertices.pending(v);
    if (!VertexTeam::leads()) return;
    const Vec4 x = position[v];
    position[v] = pbd::with_w(x.xyz() + x.w * push, x.w);
    accumulated_delta[v] = pbd::shifted(accumulated_delta[v], pbd::recorded_part(x.w) * push);
  }
};

/// Restores the vertices' own masses, and stores the loaded ones. Held ones have their own.
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

/// Computes the inverse mass of cloth at a contact for the density constraint, like that of a body
/// (fluid/kernel/density_wall_kernels.h). Each vertex is split among its contacts.
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

/// Stores the velocity changes by contacts since the position solve (restitution).
struct WeighVelocities {
  AtTouches at;

  MENISCUS_HD void operator()(uint32_t k) const {
    if (k < at.near.count()) at.note_pushes(k);
  }
};

/// Applies them to the vertices. A held vertex stores the impulse.
struct LoadVelocities {
  LoadedVertices vertices;
  View<const float> loaded;  // by vertex, 1/kg
  View<Vec4> velocity;       // by vertex
  View<Vec4> change;         // by vertex, m/s
  pbd::Withstanding held;
  uint32_t first_vertex;
  float inverse_dt;

  MENISCUS_HD void operator()(uint32_t v) const {
    if (!vertices.any(v)) return;
    const Vec3 pending = vertices.pending(v);
    if (!VertexTeam::leads()) return;
    const bool stays = is_held(held.contacts, first_vertex + v, loaded[v]);
    const Vec3 step = (stays ? 0 : loaded[v] * inverse_dt) * pending;
    change[v] = pbd::with_w(step, 0);
    if (stays) return held.add(first_vertex + v, pending);
    velocity[v] = pbd::with_w(velocity[v].xyz() + step, velocity[v].w);
  }
};

/// Changes the velocities of carried particles with the cloth, and marks the particles that press, for the
/// next substep.
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
