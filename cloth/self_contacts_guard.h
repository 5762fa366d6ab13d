// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The last resort of cloth-to-cloth contacts: nothing goes through, whatever the solve has left.
#pragma once

#include "cloth/self_contacts_find.h"

namespace meniscus::cloth::self_contact_kernels {

/// Keeps each vertex near its way, and where pairs were looked for, and notes how far it strays from its way:
/// the next substep allows for that.
struct Contain {
  View<const Vec4> previous;  // by vertex
  View<const uint32_t> vertex_part;
  KeptPlaces kept;
  View<Vec4> foreseen;  // afterwards: see TakenBack
  View<Vec4> position, moved;
  View<float> strayed;
  View<uint32_t> counters;

  MENISCUS_HD void operator()(uint32_t v) const {
    if (v == 0) counters[expired] = 0;  // what has expired was listed anew
    if (vertex_part[v] == no_index) return;
    const Vec4 x = position[v], ahead = foreseen[v];
    const Vec3 from = previous[v].xyz(), to = ahead.xyz();
    const Vec3 lower = min(from, to), upper = max(from, to);
    strayed[v] = pbd::max(0, max_component(max(x.xyz() - upper, lower - x.xyz())));
    const TakenBack taken{foreseen, counters};
    taken.begin(v);
    if (x.w == 0) return;
    const Aabb box = pbd::inflated({lower, upper}, ahead.w);
    const Vec3 inside = kept.inside(v, max(box.lower, min(box.upper, x.xyz())));
    if (inside == x.xyz()) return;
    taken.add(v, x.xyz() - inside);
    position[v] = pbd::with_w(inside, x.w);
    moved[v] = pbd::with_w(moved[v].xyz() + (inside - x.xyz()), moved[v].w);
  }
};

/// While a group of threads sums up what groups of triangles have lost.
struct LostScratch {
  static constexpr uint32_t groups = 64;

  Vec3 impulse[groups];  // kg·m
  float mass[groups];    // kg
  uint32_t part[groups];
};

/// Sums up the momentum of vertices that were taken back, and what all of their part weigh.
struct SumLost {
  using Scratch = LostScratch;

  ClothState cloth;
  View<const Vec4> taken;  // by vertex, m: see TakenBack
  PartSums sums;
  View<const uint32_t> counters;

  template <class Group>
  MENISCUS_HD void operator()(const Group& group, Scratch& scratch, uint32_t n) const {
    if (counters[lost] == 0) return;
    const uint32_t first = Scratch::groups * n, all = cloth.tree.triangles.count / 8;
    const uint32_t count = all - first < Scratch::groups ? all - first : Scratch::groups;
    group.for_each(count, [&](uint32_t k) { sum(scratch, k, first + k); });
    // The first group of each part adds up those that follow it.
    group.for_each(count, [&](uint32_t k) {
      const uint32_t part = scratch.part[k];
      if (k > 0 && scratch.part[k - 1] == part) return;
      Vec3 impulse{0, 0, 0};
      float mass = 0;
      for (uint32_t other = k; other < count && scratch.part[other] == part; ++other) {
        impulse += scratch.impulse[other];
        mass += scratch.mass[other];
      }
      sums.add(part, impulse, mass);
    });
  }

 private:
  /// Each vertex belongs to one of its triangles.
  MENISCUS_HD void sum(Scratch& scratch, uint32_t k, uint32_t g) const {
    Vec3 impulse{0, 0, 0};
    float mass = 0;
    for (uint32_t place = 8 * g; place < 8 * g + 8; ++place) {
      const SurfaceTriangle t = load(cloth.tree.triangles, place);
      for (uint32_t corner = 0; corner < 3; ++corner) {
        if (!(cloth.features[place] & owns_vertex << corner)) continue;
        const uint32_t v = corner_of(t, corner);
        const float w = cloth.position[v].w, m = w > 0 ? 1 / w : 0.0f;
        impulse += m * taken[v].xyz();
        mass += m;
      }
    }
    scratch.impulse[k] = impulse;
    scratch.mass[k] = mass;
    scratch.part[k] = cloth.tree.triangles[8 * g].part;
  }
};

/// Gives the momentum of vertices that were taken back to all of their part, which stay where they are.
/// Nothing moves against anything else in it by that; given to those around them it kept crumpled cloth
/// stretched.
struct HandOn {
  View<const uint32_t> vertex_part;
  View<const Vec4> position;  // by vertex
  View<Vec4> moved;           // by vertex
  PartSums sums;
  View<const uint32_t> counters;

  MENISCUS_HD void operator()(uint32_t v) const {
    if (counters[lost] == 0 || vertex_part[v] == no_index || position[v].w == 0) return;
    moved[v] = pbd::with_w(moved[v].xyz() + sums.way(vertex_part[v]), moved[v].w);
  }
};

/// While a group of threads looks for crossings: sixteen groups of triangles, or sixteen around one, of which
/// some have folded; and pairs of triangles, by number.
struct CrossingScratch {
  static constexpr uint32_t chunk = 128, groups = chunk / 8, most_hits = 1024;

  uint32_t bent[groups], folded[groups], hits[most_hits];
  uint32_t hit_count;
};

/// Looks for pairs that would pass through one another, and has them go on together. If that makes others
/// meet, these join them in the next round. Nothing leaves the place that pairs were looked for in, so that
/// no others need be looked for, but in sheets that are smooth no longer.
struct FindCrossings {
  using Scratch = CrossingScratch;

  FeaturePairs features;
  View<const FeatureCode> candidate_list;
  SheetViews sheets;
  Zones zones;
  View<uint32_t> counters;
  uint32_t round, stride;
  /// m: what is nearer hardly comes nearer still, and what is nearer than a tenth of it does not at all, as
  /// it would soon be lost in rounding.
  float least;

  template <class Group>
  MENISCUS_HD void operator()(const Group& group, Scratch& scratch, uint32_t n) const {
    if (counters[doomed] != 0 || (round > 0 && counters[crossings + round - 1] == 0)) return;
    by_chunks(n, zones.mark.count, Scratch::chunk, [&](uint32_t first, uint32_t count) {
      group.for_each(count, [&](uint32_t k) { zones.forget_sums(first + k); });
    });
    by_chunks(
        n, listed(candidate_list, counters[candidates]), Scratch::chunk, [&](uint32_t first, uint32_t count) {
          group.for_each(
              count, [&](uint32_t k) { check(features.cloth.corners_of(load(candidate_list, first + k))); });
        });
    by_chunks(n, features.cloth.tree.triangles.count, Scratch::chunk, [&](uint32_t first, uint32_t count) {
      group.for_each(Scratch::groups, [&](uint32_t k) { scratch.bent[k] = 0; });
      group.for_each(count, [&](uint32_t k) {
        if (is_bent(first + k)) pbd::atomic_max(scratch.bent[k / 8], 1);
      });
      for (uint32_t k = 0; 8 * k < count; ++k)
        if (scratch.bent[k]) check_around(group, scratch, first / 8 + k);
      group.for_each(0, [](uint32_t) {});  // all have read it
    });
  }

 private:
  /// Of `count` things each group of threads takes every so many-th chunk.
  template <class Visit>
  MENISCUS_HD void by_chunks(uint32_t n, uint32_t count, uint32_t chunk, const Visit& visit) const {
    for (uint32_t first = chunk * n; first < count; first += chunk * stride)
      visit(first, count - first < chunk ? count - first : chunk);
  }

  MENISCUS_HD Vec3 normal(const SurfaceTriangle& t) const {
    const View<const Vec4> x = features.cloth.position;
    const Vec3 a = x[t.a].xyz();
    return cross(x[t.b].xyz() - a, x[t.c].xyz() - a);
  }
  /// Whether a triangle's normal has left its group's cone.
  MENISCUS_HD bool is_bent(uint32_t place) const {
    const SurfaceTriangle t = load(features.cloth.tree.triangles, place);
    return t.a != no_index && !sheets.is_in_cone(place / 8, normal(t));
  }
  MENISCUS_HD bool ends_smoothness(uint32_t place, uint32_t g) const {
    const SurfaceTriangle t = load(features.cloth.tree.triangles, place);
    return t.a != no_index && sheets.ends_smoothness(g, normal(t));
  }

  /// Looks into the sheets around a group that it may have folded; pairs are then listed anew.
  template <class Group>
  MENISCUS_HD void check_around(const Group& group, Scratch& scratch, uint32_t g) const {
    const uint32_t end = sheets.neighbour_start[g + 1];
    for (uint32_t first = sheets.neighbour_start[g]; first < end; first += Scratch::groups) {
      const uint32_t left = end - first < Scratch::groups ? end - first : Scratch::groups;
      group.for_each(left, [&](uint32_t k) { scratch.folded[k] = 0; });
      group.for_each(8 * left, [&](uint32_t k) {
        if (ends_smoothness(8 * g + k % 8, sheets.neighbours[first + k / 8]))
          pbd::atomic_max(scratch.folded[k / 8], 1);
      });
      for (uint32_t k = 0; k < left; ++k) {
        if (!scratch.folded[k]) continue;
        pbd::atomic_max(counters[expired], 1);
        check_sheet(group, scratch, sheets.neighbours[first + k]);
      }
      group.for_each(0, [](uint32_t) {});  // all have read it
    }
  }

  /// Around a group: what was left out as the sheet was smooth.
  template <class Group>
  MENISCUS_HD void check_sheet(const Group& group, Scratch& scratch, uint32_t g) const {
    constexpr uint32_t at_once = Scratch::most_hits / 64;
    const uint32_t end = sheets.neighbour_start[g + 1];
    for (uint32_t first = sheets.neighbour_start[g]; first < end; first += at_once) {
      const uint32_t left = end - first < at_once ? end - first : at_once;
      group.for_each(1, [&](uint32_t) { scratch.hit_count = 0; });
      group.for_each(8 * left, [&](uint32_t k) {
        const uint32_t other = sheets.neighbours[first + k / 8];
        if (other < g) return;
        uint32_t mask = features.overlapping(8 * g + k % 8, other);
        for (; mask != 0; mask &= mask - 1)
          scratch.hits[pbd::append(scratch.hit_count, 1)] = 8 * k + pbd::lowest_bit(mask);
      });
      group.for_each(scratch.hit_count, [&](uint32_t n) {
        const uint32_t hit = scratch.hits[n];
        const GroupPair two = places_of({g, sheets.neighbours[first + hit / 64]}, hit % 64);
        features.of_two(two.first, two.second,
                        [&](FeatureCode code) { check(features.cloth.corners_of(code)); });
      });
    }
  }

  MENISCUS_HD void check(const Corners& corners) const {
    if (round > 0 && !has_changed(corners)) return;
    const FeaturePair pair = pair_of(corners, features.cloth.previous, features.cloth.position);
    if (pbd::least_gap(pair) > least) return;
    const float motion = relative_motion(pair), distance = nearest(pair, 0).distance;
    if (motion == 0 || distance <= 0) return;
    const bool nearly_lost = distance < 0.1f * least;
    const float gap = nearly_lost ? 0.5f * distance : pbd::min(0.9f * distance, least);
    const float t = motion < distance - gap ? 2 : time_of_nearness(pair, gap);
    if (t > 1 && !(nearly_lost && nearest(pair, 1).distance < distance)) return;
    if (nothing_moves(corners)) return;
    pbd::atomic_add(counters[crossings + round], 1);
    zones.unite(corners, round, nearly_lost || motion < rounding(corners));
  }

  /// In the last round. What is unchanged since then has been looked at before.
  MENISCUS_HD bool has_changed(const Corners& corners) const {
    for (uint32_t k = 0; k < 4; ++k)
      if (zones.has_moved(corners.vertex(k), round)) return true;
    return false;
  }
  MENISCUS_HD bool nothing_moves(const Corners& corners) const {
    for (uint32_t k = 0; k < 4; ++k)
      if (features.cloth.position[corners.vertex(k)].w != 0) return false;
    return true;
  }
  /// m: what moves by no more than this may do so by the rounding of a zone's motion.
  MENISCUS_HD float rounding(const Corners& corners) const {
    const Vec3 x = features.cloth.position[corners.vertex(0)].xyz();
    return 1e-6f * max_component(max(x, -x));
  }
};

/// What the substep found, for the host; the most of any, up to the first whose lists had no room.
struct NoteCounters {
  View<const uint32_t> counters;
  View<uint32_t> found;

  MENISCUS_HD void operator()(uint32_t k) const {
    if (counters[doomed] == 0 && found[k] < counters[k]) found[k] = counters[k];
  }
};

}  // namespace meniscus::cloth::self_contact_kernels
