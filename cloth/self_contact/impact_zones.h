// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Impact zones: vertices that would pass through one another share one motion.
#pragma once

#include "cloth/self_contact/own_motion.h"
#include "cloth/self_contact/solve.h"
#include "cloth/self_contact/tuning.h"
#include "pbd/math/union_find.h"
#include "pbd/math/units.h"

namespace meniscus::cloth::self_contact_kernels {

/// Vertices that share one motion for the rest of a substep (Provot 1997; Harmon et al. 2008 let zones rotate
/// as well). It is the motion of their centre of mass since the start of the substep, when nothing had passed
/// through. Momentum is conserved, and there is no relative motion within a zone. Zones only grow.
struct ImpactZones {
  View<uint32_t> label;
  /// By vertex; 0 for a vertex in no zone. Bits 0 to 7: the last round, counted from 1, in which the zone was
  /// found to need a new motion. Bits 8 to 15: the last round in which the vertex moved with its zone. The
  /// bit `stopped` marks a vertex that could not move with it. The bit `parted` marks one that has made its
  /// own motion.
  View<uint32_t> mark;
  /// By zone, at the vertex that names it: the vertex that determines the motion of the zone, if any.
  View<uint32_t> anchor;
  View<int64_t> mass;  // likewise
  PushSums momentum;   // likewise, kg·m
  float mass_unit;     // kg

  static constexpr uint32_t stopped = 1u << 31, parted = 1u << 30, a_round = 0xff, moved_shift = 8;
  /// Anchors: none; each vertex's own motion; else, minus 1, a vertex that nothing moves.
  static constexpr uint32_t itself = no_index, own = 0;

  MENISCUS_HD uint32_t name(uint32_t v) const { return pbd::UnionFind{label}.name(v); }
  MENISCUS_HD uint32_t mark_of(uint32_t v) const { return pbd::atomic_load(mark[v]); }
  MENISCUS_HD bool has_parted(uint32_t v) const { return (mark_of(v) & parted) != 0; }
  MENISCUS_HD static bool is_stopped(uint32_t mark) { return (mark & stopped) != 0; }
  /// Whether a vertex with this mark was found to need a new motion in this round.
  MENISCUS_HD static bool is_needed(uint32_t mark, uint32_t round) { return (mark & a_round) == round + 1; }
  /// Whether the vertex moved in the round before this one. What other threads find meanwhile does not change
  /// that. The choice of pairs must not depend on the order of threads.
  MENISCUS_HD bool has_moved(uint32_t v, uint32_t round) const {
    return (mark_of(v) >> moved_shift & a_round) == round;
  }
  MENISCUS_HD void need(uint32_t v, uint32_t round) const {
    pbd::atomic_max(mark[v], (mark_of(v) & ~a_round) | (round + 1));
  }

  MENISCUS_HD void begin(uint32_t v) const {
    forget_sums(v);
    label[v] = v;
    mark[v] = 0;
    anchor[v] = itself;
  }
  MENISCUS_HD void forget_sums(uint32_t v) const {
    if (mark_of(v) == 0) return;
    momentum.take(v);
    mass[v] = 0;
  }

  /// From now on these vertices move together. With `stop`, their zone stops.
  MENISCUS_HD void unite(const Corners& corners, uint32_t round, bool stop) const {
    for (uint32_t k = 0; k < 4; ++k) {
      const uint32_t v = corners.vertex(k);
      need(v, round);
      if (stop) pbd::atomic_min(anchor[v], own);
      if (k > 0) pbd::UnionFind{label}.unite(corners.vertex(0), v);
    }
  }
};

/// Sums up the masses and the momentum of zones, and finds their anchors.
struct GatherImpactZones {
  View<const Vec4> previous, position;  // by vertex
  ImpactZones impact_zones;
  View<uint32_t> all_counters;
  uint32_t vertices_of_world;
  uint32_t round;

  MENISCUS_HD void operator()(uint32_t v) const {
    const View<uint32_t> counters = counters_of(all_counters, v / vertices_of_world);
    if (v % vertices_of_world == 0) counters[folded_sheets] = 0;  // these have been checked
    const uint32_t mark = impact_zones.mark_of(v);
    if (counters[crossings + round] == 0 || mark == 0) return;
    const uint32_t name = impact_zones.name(v);
    const bool stopped = ImpactZones::is_stopped(mark);
    if (stopped || ImpactZones::is_needed(mark, round)) impact_zones.need(name, round);
    const Vec4 x = position[v];
    const uint32_t anchor = stopped ? ImpactZones::own : x.w == 0 ? v + 1 : ImpactZones::itself;
    pbd::atomic_min(impact_zones.anchor[name], anchor);
    if (v != name) pbd::atomic_min(impact_zones.anchor[name], impact_zones.anchor[v]);
    if (x.w == 0) return;
    const float m = 1 / x.w;
    pbd::atomic_add(impact_zones.mass[name], pbd::whole_units(m / impact_zones.mass_unit));
    impact_zones.momentum.add(name, m * (x.xyz() - previous[v].xyz()));
  }
};

/// The displacement that was taken from vertices that would have left the place that was searched. Their
/// momentum is transferred at the end.
struct RolledBack {
  View<Vec4> ways;          // by vertex, m
  View<uint32_t> counters;  // of its world

  MENISCUS_HD void begin(uint32_t v) const { ways[v] = {0, 0, 0, 0}; }
  MENISCUS_HD void add(uint32_t v, Vec3 displacement) const {
    ways[v] = pbd::with_w(ways[v].xyz() + displacement, 0);
    pbd::atomic_max(counters[lost], 1);
  }
};

/// By piece: three numbers of momentum and one of mass. These integers have the same sum in any order.
struct PieceSums {
  View<int64_t> sums;
  float unit;       // kg·m, of the momentum; a power of 2
  float mass_unit;  // kg, coarse: it includes fluid that cloth carries

  MENISCUS_HD void begin(uint32_t piece) const {
    for (uint32_t k = 0; k < 4; ++k) sums[4 * piece + k] = 0;
  }
  MENISCUS_HD void add(uint32_t piece, Vec3 positional_impulse, float mass) const {
    pbd::atomic_add(sums[4 * piece], pbd::whole_units(positional_impulse.x / unit));
    pbd::atomic_add(sums[4 * piece + 1], pbd::whole_units(positional_impulse.y / unit));
    pbd::atomic_add(sums[4 * piece + 2], pbd::whole_units(positional_impulse.z / unit));
    pbd::atomic_add(sums[4 * piece + 3], pbd::whole_units(mass / mass_unit));
  }
  /// The displacement of the whole piece, m.
  MENISCUS_HD Vec3 displacement(uint32_t piece) const {
    const int64_t* sum = &sums[4 * piece];
    if (sum[3] == 0) return {0, 0, 0};
    const float scale = unit / (mass_unit * static_cast<float>(sum[3]));
    return scale * Vec3{static_cast<float>(sum[0]), static_cast<float>(sum[1]), static_cast<float>(sum[2])};
  }
};

/// Moves vertices with their zones, inside the place that was searched. A zone that would have to leave it
/// stops in the next round. So does a zone that would enter a solid. Its vertices then move by their own
/// motion. If the last round but one still finds a pair, all vertices do. If the last one still finds a pair,
/// all vertices move with their frames from where they were at the start of the substep. Where there are
/// several frames, the step is then repeated in one.
struct MoveImpactZones {
  ClothState cloth;
  pbd::ContactView contacts;               // of all particles
  uint32_t sorted;                         // see ParticleView
  View<Vec4> position, accumulated_delta;  // by vertex
  ImpactZones impact_zones;
  OwnMotion own_motion;
  View<Vec4> ways;  // see RolledBack
  View<uint32_t> all_counters;
  uint32_t round;

  MENISCUS_HD void operator()(uint32_t v) const {
    const View<uint32_t> counters = counters_of(all_counters, v / cloth.of_world.vertices);
    const RolledBack taken{ways, counters};
    if (counters[crossings + round] == 0) return;
    if (cloth.frames.piece[v] == no_index) return;  // a vertex of a rope
    const bool last = round + 1 == most_rounds, all = last || round + 2 == most_rounds;
    const uint32_t mark = impact_zones.mark_of(v);
    if (mark == 0 && !all) return;
    const uint32_t name = impact_zones.name(v), of_name = impact_zones.mark_of(name);
    if (!all && !ImpactZones::is_needed(of_name, round) && !ImpactZones::is_stopped(of_name)) return;
    const Vec4 x = position[v];
    if (x.w == 0) return;
    const bool is_own = all || impact_zones.anchor[name] == ImpactZones::own;
    // Computed with displacements, not positions: the rounding of positions would lose momentum.
    const Vec3 from = cloth.previous[v].xyz(), now = x.xyz() - from;
    const Vec3 frame = cloth.frames.at(v).xyz();
    const Vec3 wanted = last ? frame : is_own ? own_motion.displacement(v, from, frame) : motion_of(name);
    const Vec3 to = from + wanted;
    // A vertex's own motion ends inside, as that of the solve does.
    const Vec3 inside = is_own ? to : cloth.kept.inside(v, to);
    const bool leaves = inside != to, stops = leaves || (!is_own && enters_solid(v, from, to));
    const Vec3 displacement = leaves ? inside - from : wanted;
    // In a stopped zone, each vertex loses its fraction of the whole momentum, as if the zone had moved
    // on.
    const Vec3 due = !is_own ? wanted : mark == 0 ? now : mean_motion(name);
    if (due != displacement) taken.add(v, due - displacement);
    if (last && counters[several_frames] != 0) pbd::atomic_max(counters[frames_meet], 1);
    if (stops && !last) pbd::atomic_add(counters[crossings + round + 1], 1);
    constexpr uint32_t kept = ImpactZones::stopped | ImpactZones::parted;
    pbd::atomic_store(impact_zones.mark[v], (round + 1) << ImpactZones::moved_shift | (round + 1) |
                                                (mark & kept) | (stops ? ImpactZones::stopped : 0) |
                                                (is_own ? ImpactZones::parted : 0));
    position[v] = pbd::with_w(inside, x.w);
    accumulated_delta[v] = pbd::shifted(accumulated_delta[v], displacement - now);
  }

  MENISCUS_HD bool enters_solid(uint32_t v, Vec3 from, Vec3 to) const {
    for (uint32_t k = contacts.start[sorted + v]; k < contacts.start[sorted + v + 1]; ++k) {
      const pbd::Contact& c = contacts.contacts[k];
      const bool yields = c.body == pbd::on_cloth || c.body_inverse_mass > 0 || is_attachment(c);
      const float distance = plane_distance(c, to);
      if (!yields && distance < self_contact_tuning::least_to_solid * c.radius &&
          distance < plane_distance(c, from))
        return true;
    }
    return false;
  }
  MENISCUS_HD Vec3 motion_of(uint32_t name) const {
    const uint32_t anchor = impact_zones.anchor[name];
    if (anchor != ImpactZones::itself) return position[anchor - 1].xyz() - cloth.previous[anchor - 1].xyz();
    return mean_motion(name);
  }
  MENISCUS_HD Vec3 mean_motion(uint32_t name) const {
    return 1 / (impact_zones.mass_unit * static_cast<float>(impact_zones.mass[name])) *
           impact_zones.momentum.of(name);
  }
};

}  // namespace meniscus::cloth::self_contact_kernels
