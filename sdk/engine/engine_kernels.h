// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Kernels for read-outs, measurements and impulses.
#pragma once

#include "collision/contact/shape_contacts.h"
#include "fluid/kernel/mirror_ghosts.h"
#include "pbd/math/hash.h"
#include "pbd/particles.h"
#include "sdk/engine/engine.h"
#include "sdk/engine/tuning.h"

namespace meniscus::engine_kernels {

using pbd::View;

/// Writes xyz of sorted particles in the user's order.
struct ReadVector {
  View<const pbd::Vec4> from;
  View<const uint32_t> slot;
  View<Vec3> to;

  MENISCUS_HD void operator()(uint32_t i) const { to[slot[i]] = from[i].xyz(); }
};

/// Moves ellipsoids to the user's frame.
struct ShiftEllipsoids {
  View<Ellipsoid> ellipsoids;
  Vec3 by;

  MENISCUS_HD void operator()(uint32_t i) const { ellipsoids[i].centre += by; }
};

/// Moves points to the user's frame.
struct ShiftVectors {
  View<Vec3> points;
  Vec3 by;

  MENISCUS_HD void operator()(uint32_t i) const { points[i] += by; }
};

struct ReadGroup {
  View<const pbd::Phase> phase;
  View<const uint32_t> slot;
  View<uint32_t> to;

  MENISCUS_HD void operator()(uint32_t i) const { to[slot[i]] = pbd::phase_group(phase[i]); }
};

struct ReadMultipliers {
  View<const fluid::density_kernels::Multiplier> from;
  View<const uint32_t> slot;
  View<float> to;
  float scale;

  MENISCUS_HD void operator()(uint32_t i) const { to[slot[i]] = scale * from[i].value; }
};

/// Whether a point is where no particle should be: beyond a container's wall, or inside a solid. A particle
/// beyond a wall with an opening has left; the container's other walls then ignore it.
MENISCUS_HD inline bool is_outside(const collision::ShapeSet& set, const collision::CandidateView& candidates,
                                   const CollisionFilter& filter, uint32_t i, Vec3 p, float reach,
                                   float radius) {
  bool outside = false;
  candidates.for_each(i, [&](uint32_t k) {
    const collision::Shape& shape = set.shapes[k];
    if (outside || !collide(shape, filter)) return;
    if (collision::sample_surface(set, shape, p, reach).distance >= 0) return;
    outside = shape.kind != collision::ShapeKind::plane || !left_through_opening(set, shape, {p, p}, radius);
  });
  return outside;
}

/// Distance to the nearest solid that `skip` does not exclude; `reach` if none is that near.
template <class Skip>
MENISCUS_HD float nearest_solid(const collision::ShapeSet& set, const CollisionFilter& filter, Vec3 p,
                                float reach, const Skip& skip) {
  float nearest = reach;
  for (uint32_t k = 0; k < set.shapes.count; ++k) {
    const collision::Shape& shape = set.shapes[k];
    if (!collide(shape, filter)) continue;
    if (shape.kind != collision::ShapeKind::plane && out_of_reach(shape, p, p, reach)) continue;
    const float distance = collision::sample_surface(set, shape, p, reach).distance;
    if (distance < nearest && !skip(shape)) nearest = distance;
  }
  return nearest;
}

struct SolidDistance {
  collision::ShapeSet set;
  View<const Vec3> points;
  View<float> distance;
  float reach;
  CollisionFilter filter;

  MENISCUS_HD void operator()(uint32_t i) const {
    distance[i] = nearest_solid(set, filter, points[i], reach, [](const collision::Shape&) { return false; });
  }
};

/// The first of the nearest solids, for one point. Its distance is `reach` if none is that near.
struct FindNearest {
  collision::ShapeSet set;
  Vec3 point;
  float reach;
  View<NearestSolid> nearest;

  MENISCUS_HD void operator()(uint32_t) const {
    NearestSolid best{pbd::no_index, TouchedKind::shape, {0, 1, 0}, reach};
    for (uint32_t k = 0; k < set.shapes.count; ++k) {
      const collision::Shape& shape = set.shapes[k];
      if (shape.kind != collision::ShapeKind::plane && out_of_reach(shape, point, point, reach)) continue;
      const collision::SurfaceSample s = collision::sample_surface(set, shape, point, reach);
      if (!(s.distance < best.distance)) continue;
      const TouchedKind kind = shape.body == pbd::no_index ? TouchedKind::shape : TouchedKind::body;
      best = {shape.owner, kind, s.normal, s.distance};
    }
    nearest[0] = best;
  }
};

/// Marks particles inside a solid, or nearer to it than motion can bring them: see phase_overlapping.
struct NotePlaced {
  collision::ShapeSet set;
  collision::CandidateView candidates;
  collision::shape_contact_kernels::Touches touches;
  View<const pbd::Vec4> position;
  View<pbd::Phase> phase;
  pbd::ChosenWorlds worlds, worlds_of_vertices;

  MENISCUS_HD void operator()(uint32_t i) const {
    const uint32_t sorted = touches.sorted;
    if (!(i < sorted ? worlds.has(i) : worlds_of_vertices.has(i - sorted))) return;
    const collision::Touch touch = touches.of(i);
    const Vec3 p = position[i].xyz();
    const float least = engine_tuning::overlapping * touch.radius;
    bool is_in = false;
    candidates.for_each(i, [&](uint32_t k) {
      const collision::Shape& shape = set.shapes[k];
      if (is_in || !collide(shape, touch.filter) || touches.is_attached(i, shape.body)) return;
      is_in = collision::sample_surface(set, shape, p, touch.radius).distance < least;
    });
    if (is_in) phase[i] |= pbd::phase_overlapping;
  }
};

/// Adds an impulse to the velocity of a particle; held ones have inverse mass 0 and do not change.
MENISCUS_HD inline void push(View<const pbd::Vec4> position, View<pbd::Vec4> velocity, uint32_t i,
                             Vec3 impulse) {
  velocity[i] = pbd::with_w(velocity[i].xyz() + position[i].w * impulse, velocity[i].w);
}

/// Applies impulses to fluid particles. The slots ascend: each particle searches them for its own.
struct PushParticles {
  View<const pbd::Vec4> position;
  View<pbd::Vec4> velocity;
  View<const uint32_t> slot;
  View<const uint32_t> pushed;
  View<const Vec3> impulse;
  uint32_t sorted;

  MENISCUS_HD void operator()(uint32_t i) const {
    uint32_t low = 0, high = pushed.count;
    while (low < high) {
      const uint32_t middle = (low + high) / 2;
      if (pushed[middle] < slot[i])
        low = middle + 1;
      else
        high = middle;
    }
    if (low < pushed.count && pushed[low] == slot[i]) push(position, velocity, i, impulse[low]);
  }
};

/// Applies impulses to vertices, by number; a vertex occurs once.
struct PushVertices {
  View<const pbd::Vec4> position;
  View<pbd::Vec4> velocity;
  View<const uint32_t> slot;
  View<const uint32_t> pushed;
  View<const Vec3> impulse;
  uint32_t sorted;

  MENISCUS_HD void operator()(uint32_t k) const { push(position, velocity, sorted + pushed[k], impulse[k]); }
};

struct StateSum {
  double kinetic, potential;
  float max_speed2;
  uint32_t non_finite, outside;
};

struct SumState {
  View<const pbd::Vec4> position, velocity;
  collision::ShapeSet set;
  collision::CandidateView candidates;
  collision::shape_contact_kernels::Touches touches;
  Vec3 gravity;
  float reach;

  MENISCUS_HD StateSum operator()(uint32_t i) const {
    const pbd::Vec4 x = position[i];
    const Vec3 v = velocity[i].xyz();
    if (!is_finite(x.xyz()) || !is_finite(v)) return {0, 0, 0, 1, 0};
    const double mass = x.w > 0 ? 1.0 / x.w : 0;
    const float v2 = dot(v, v);
    const collision::Touch touch = touches.of(i);
    const bool in_duct = (touches.phase[i] & pbd::phase_piston) != 0;
    return {0.5 * mass * v2, -mass * dot(gravity, x.xyz()), v2, 0,
            !in_duct && is_outside(set, candidates, touch.filter, i, x.xyz(), reach, touch.radius)};
  }
};

struct AddStates {
  MENISCUS_HD StateSum operator()(const StateSum& a, const StateSum& b) const {
    return {a.kinetic + b.kinetic, a.potential + b.potential, pbd::max(a.max_speed2, b.max_speed2),
            a.non_finite + b.non_finite, a.outside + b.outside};
  }
};

/// Counts the particles with more walls in reach than may be mirrors.
struct CountCrowdedAtWalls {
  pbd::ContactView contacts;
  View<const pbd::Vec4> position;
  View<const pbd::Phase> phase;
  float h;  // m

  MENISCUS_HD uint64_t operator()(uint32_t i) const {
    return !pbd::is_grain(phase[i]) &&
           fluid::walls_at(contacts, i, position[i].xyz(), h) > fluid::MirrorPlanes::most;
  }
};

struct CountNeighbours {
  pbd::NeighbourView neighbours;

  MENISCUS_HD uint64_t operator()(uint32_t i) const { return neighbours.size(i); }
};

/// The hash of a particle's number, position and velocity.
struct HashParticle {
  View<const pbd::Vec4> position, velocity;
  View<const uint32_t> number;

  MENISCUS_HD uint64_t operator()(uint32_t i) const {
    return pbd::element_hash(number[i], position[i].xyz(), velocity[i].xyz());
  }
};

struct AddCounts {
  MENISCUS_HD uint64_t operator()(uint64_t a, uint64_t b) const { return a + b; }
};

}  // namespace meniscus::engine_kernels
