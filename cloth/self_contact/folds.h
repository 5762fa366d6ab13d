// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Finds where sheets have folded. Their pairs were left out of the lists while the sheets were smooth.
#pragma once

#include "cloth/self_contact/impact_zones.h"

namespace meniscus::cloth::self_contact_kernels {

/// What the rounds of the fail-safe know about groups of triangles.
struct Folds {
  View<uint32_t> state;     // by group: the last round that found its vertices moved, and `bent`
  View<uint32_t> noted;     // by group, counted from 1: the last round in which it was put on the list
  View<uint32_t> list;      // by world: the groups whose sheets are to be checked in this round
  View<uint32_t> counters;  // by world: `folded_sheets` is the length of the list
  uint32_t groups;          // of a world

  static constexpr uint32_t bent = 1u << 31;  // a normal has left the group's cone

  /// The counters and the list of one world.
  MENISCUS_HD View<uint32_t> counters_in(uint32_t world) const { return counters_of(counters, world); }
  MENISCUS_HD View<uint32_t> list_in(uint32_t world) const { return part_of(list, world, groups); }
  /// The part of the preparation for a substep that one of a world's `threads` threads does.
  MENISCUS_HD void begin(uint32_t world, uint32_t thread, uint32_t threads) const {
    const View<uint32_t> own = part_of(noted, world, groups);
    for (uint32_t g = thread; g < groups; g += threads) own[g] = 0;
    if (thread == 0) counters_in(world)[folded_sheets] = 0;
  }
  /// Whether vertices of a group have moved since its pairs were last checked.
  MENISCUS_HD bool has_changed(uint32_t g, uint32_t round) const {
    return round == 0 || (state[g] & ~bent) == round;
  }
  MENISCUS_HD void add(uint32_t g, uint32_t round) const {
    const uint32_t seen = pbd::atomic_load(noted[g]);
    if (seen > round || pbd::atomic_exchange_if(noted[g], seen, round + 1) != seen) return;
    const uint32_t world = g / groups;
    list_in(world)[pbd::append(counters_in(world)[folded_sheets], 1)] = g;
  }
};

/// Working memory for sixteen groups of eight triangles.
struct FoldScratch {
  static constexpr uint32_t groups = 16;

  uint32_t changed[groups], bent[groups];
};

/// Runs before each round of the fail-safe. Finds which groups have changed since the last round, and which
/// sheets bent groups may have folded. Pairs are then listed again.
struct FindFolds {
  using Scratch = FoldScratch;

  ClothState cloth;
  SheetViews sheets;
  ImpactZones impact_zones;
  Folds folds;
  uint32_t round;

  template <class Group>
  MENISCUS_HD void operator()(const Group& group, Scratch& scratch, uint32_t n) const {
    const GroupRange range(n, Scratch::groups, folds.groups);
    if (!is_round_needed(folds.counters_in(range.world), round)) return;
    const uint32_t first = range.first, count = range.count;
    group.for_each(count, [&](uint32_t k) {
      scratch.changed[k] = round == 0;
      scratch.bent[k] = 0;
    });
    if (round > 0) {
      group.for_each(8 * count, [&](uint32_t k) {
        if (has_moved(8 * first + k)) pbd::atomic_max(scratch.changed[k / 8], 1);
      });
    }
    group.for_each(8 * count, [&](uint32_t k) {
      if (scratch.changed[k / 8] && is_bent(8 * first + k)) pbd::atomic_max(scratch.bent[k / 8], 1);
    });
    group.for_each(count, [&](uint32_t k) { note(scratch, k, folds.state[first + k]); });
    for (uint32_t k = 0; k < count; ++k)
      if (scratch.bent[k]) mark_folded_neighbours(group, first + k);
  }

 private:
  MENISCUS_HD bool has_moved(uint32_t place) const {
    const SurfaceTriangle t = load(cloth.tree.triangles, place);
    if (t.a == no_index) return false;
    return impact_zones.has_moved(t.a, round) || impact_zones.has_moved(t.b, round) ||
           impact_zones.has_moved(t.c, round);
  }
  /// Unchanged groups keep their state.
  MENISCUS_HD void note(Scratch& scratch, uint32_t k, uint32_t& state) const {
    if (scratch.changed[k])
      state = round | (scratch.bent[k] ? Folds::bent : 0);
    else
      scratch.bent[k] = state & Folds::bent;
  }

  MENISCUS_HD Vec3 normal(const SurfaceTriangle& t) const {
    const View<const Vec4> x = cloth.position;
    const Vec3 a = x[t.a].xyz();
    return cross(x[t.b].xyz() - a, x[t.c].xyz() - a);
  }
  /// Whether a triangle's normal has left the cone of its group.
  MENISCUS_HD bool is_bent(uint32_t place) const {
    const SurfaceTriangle t = load(cloth.tree.triangles, place);
    return t.a != no_index && !sheets.is_in_cone(place / 8, normal(t));
  }
  MENISCUS_HD bool ends_smoothness(uint32_t place, uint32_t g) const {
    const SurfaceTriangle t = load(cloth.tree.triangles, place);
    return t.a != no_index && sheets.ends_smoothness(g, normal(t));
  }
  template <class Group>
  MENISCUS_HD void mark_folded_neighbours(const Group& group, uint32_t g) const {
    const uint32_t begin = sheets.neighbour_start[g], count = sheets.neighbour_start[g + 1] - begin;
    group.for_each(8 * count, [&](uint32_t k) {
      const uint32_t other = sheets.neighbours[begin + k / 8];
      if (!ends_smoothness(8 * g + k % 8, other)) return;
      pbd::atomic_max(folds.counters_in(g / folds.groups)[expired], 1);
      folds.add(other, round);
    });
  }
};

}  // namespace meniscus::cloth::self_contact_kernels
