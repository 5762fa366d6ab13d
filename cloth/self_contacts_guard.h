// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The last resort of cloth-to-cloth contacts: nothing goes through, whatever the solve has left.
#pragma once

#include "cloth/self_contacts_find.h"

namespace meniscus::cloth::self_contact_kernels {

/// Keeps each vertex inside the box that its contacts were looked for in, and notes how far it would stray
/// from its way: the next substep's box allows for that. Momentum is lost where a vertex is taken back.
struct Contain {
  View<const Vec4> previous, foreseen;  // by vertex
  View<Vec4> position, moved;
  View<float> strayed;

  MENISCUS_HD void operator()(uint32_t v) const {
    const Vec4 x = position[v], to = foreseen[v];
    const Vec3 from = previous[v].xyz();
    const Vec3 lower = min(from, to.xyz()), upper = max(from, to.xyz());
    const float out = max_component(max(x.xyz() - upper, lower - x.xyz()));
    strayed[v] = pbd::max(0, out);
    if (x.w == 0 || out <= to.w) return;
    const Aabb box = pbd::inflated({lower, upper}, to.w);
    const Vec3 inside = max(box.lower, min(box.upper, x.xyz()));
    position[v] = pbd::with_w(inside, x.w);
    moved[v] = pbd::with_w(moved[v].xyz() + (inside - x.xyz()), moved[v].w);
  }
};

/// What has to be looked at again.
enum Again : uint32_t {
  others = 1,  // with all that is not of the same smooth sheet
  changed = 2  // at all: since the last round
};

/// Flags triangles: those with a vertex that is not where it was foreseen, and those of groups that are
/// squeezed, must be looked at with all others. Everywhere else, pairs that are no contacts were foreseen
/// further apart than the tolerances of both. Where a triangle's normal has left its group's cone, the sheet
/// around is looked at as well.
struct FlagTriangles {
  pbd::SurfaceTreeView tree;
  View<const Part> parts;
  View<const Vec4> foreseen, position;  // by vertex
  View<const uint32_t> squeezed;        // by group
  Zones zones;
  SheetViews sheets;
  View<const uint32_t> counters;
  View<uint8_t> flags;
  uint32_t round;

  MENISCUS_HD void operator()(uint32_t place) const {
    if (round > 0 && counters[crossings + round - 1] == 0) return;
    const SurfaceTriangle t = load(tree.triangles, place);
    flags[place] = t.a == no_index ? 0 : static_cast<uint8_t>(flags_of(t, place / 8));
  }

  MENISCUS_HD uint32_t flags_of(const SurfaceTriangle& t, uint32_t group) const {
    const float tolerance = parts[t.part].tolerance;
    const Vec3 a = position[t.a].xyz(), b = position[t.b].xyz(), c = position[t.c].xyz();
    uint32_t flag = squeezed[group] != 0 ? uint32_t{others} : 0;
    if (is_off(t.a, a, tolerance) || is_off(t.b, b, tolerance) || is_off(t.c, c, tolerance)) flag |= others;
    const Vec4 cone = sheets.cones[group];
    const Vec3 n = cross(b - a, c - a);
    if (dot(n, cone.xyz()) < cosf(pbd::min(3.1415927f, cone.w + sheets.leeway)) * length(n))
      sheets.note_fold(group);
    if (round == 0 || has_changed(t.a) || has_changed(t.b) || has_changed(t.c)) flag |= changed;
    return flag;
  }

  MENISCUS_HD bool is_off(uint32_t v, Vec3 x, float tolerance) const {
    const Vec3 off = x - foreseen[v].xyz();
    return dot(off, off) > tolerance * tolerance;
  }
  MENISCUS_HD bool has_changed(uint32_t v) const { return zones.has_moved(v, round - 1); }
};

/// While a group of threads looks for crossings: what is to be looked into, and pairs of triangles of it, by
/// number.
struct CrossingScratch {
  static constexpr uint32_t chunk = 128, most_hits = 1024;

  uint32_t found[chunk], hits[most_hits];
  uint32_t found_count, hit_count;
};

/// Looks for pairs that would pass through one another, and has them go on together. If that makes others
/// meet, these join them in the next round. Nothing leaves the boxes that the candidates were found by, so
/// that no others need be looked for, but among what was left out there.
struct FindCrossings {
  using Scratch = CrossingScratch;

  FeaturePairs features;
  View<const FeatureCode> candidate_list;
  GroupPairs pairs;
  SheetViews sheets;
  View<const Vec4> position;  // by vertex
  View<const uint8_t> flags;  // by place
  Zones zones;
  View<uint32_t> counters;
  uint32_t round, stride;
  /// m: what is nearer hardly comes nearer still, and what is nearer than a tenth of it does not at all, as
  /// it would soon be lost in rounding.
  float least;

  template <class Group>
  MENISCUS_HD void operator()(const Group& group, Scratch& scratch, uint32_t n) const {
    if (round > 0 && counters[crossings + round - 1] == 0) return;
    by_chunks(n, zones.mark.count, Scratch::chunk, [&](uint32_t first, uint32_t count) {
      group.for_each(count, [&](uint32_t k) { zones.forget_sums(first + k); });
    });
    by_chunks(n, listed(candidate_list, counters[candidates]), Scratch::chunk,
              [&](uint32_t first, uint32_t count) {
                group.for_each(count, [&](uint32_t k) { check_candidate(load(candidate_list, first + k)); });
              });
    by_chunks(n, pairs.count(), Scratch::chunk, [&](uint32_t first, uint32_t count) {
      const uint32_t found =
          gather(group, scratch, first, count, [&](uint32_t k) { return was_left_out(k); });
      check_pairs(group, scratch, found, others | changed, Which::left_out,
                  [&](uint32_t k) { return pairs.list[scratch.found[k]]; });
    });
    by_chunks(n, sheets.smooth.count, Scratch::chunk, [&](uint32_t first, uint32_t count) {
      const uint32_t found = gather(group, scratch, first, count,
                                    [&](uint32_t g) { return sheets.folded[g] && sheets.smooth[g]; });
      for (uint32_t k = 0; k < found; ++k) check_sheet(group, scratch, scratch.found[k]);
    });
  }

 private:
  /// Of `count` things each group of threads takes every so many-th chunk.
  template <class Visit>
  MENISCUS_HD void by_chunks(uint32_t n, uint32_t count, uint32_t chunk, const Visit& visit) const {
    for (uint32_t first = chunk * n; first < count; first += chunk * stride)
      visit(first, count - first < chunk ? count - first : chunk);
  }

  MENISCUS_HD void check_candidate(FeatureCode code) const {
    const uint32_t flag = flags[code.first_place()] | flags[code.second_place()];
    if (flag & changed && (flag & others || code.is_contact())) check(features.cloth.corners_of(code));
  }

  /// Pairs of edges of which one at least was not looked for among the candidates.
  MENISCUS_HD bool was_left_out(uint32_t k) const {
    const GroupPair pair = pairs.list[k];
    const View<const uint32_t>& rough = features.cloth.rough;
    if (rough[pair.first] && rough[pair.second]) return false;
    return has_all(flags_of_group(pair.first) | flags_of_group(pair.second), others | changed);
  }

  /// Around a group: what was left out as the sheet was smooth.
  template <class Group>
  MENISCUS_HD void check_sheet(const Group& group, Scratch& scratch, uint32_t g) const {
    const uint32_t start = sheets.neighbour_start[g];
    check_pairs(group, scratch, sheets.neighbour_start[g + 1] - start, changed, Which::all, [&](uint32_t k) {
      return GroupPair{g, sheets.neighbours[start + k]};
    });
  }

  /// Finds those k from first to first + count − 1 that are wanted; returns how many.
  template <class Group, class Wanted>
  MENISCUS_HD static uint32_t gather(const Group& group, Scratch& scratch, uint32_t first, uint32_t count,
                                     const Wanted& wanted) {
    group.for_each(1, [&](uint32_t) { scratch.found_count = 0; });
    group.for_each(count, [&](uint32_t k) {
      if (wanted(first + k)) scratch.found[pbd::append(scratch.found_count, 1)] = first + k;
    });
    const uint32_t found = scratch.found_count;
    group.for_each(0, [](uint32_t) {});  // all have read it
    return found;
  }

  /// Looks at `count` pairs of groups, first ≤ second: at those of their triangles that have all of the
  /// flags.
  template <class Group, class PairAt>
  MENISCUS_HD void check_pairs(const Group& group, Scratch& scratch, uint32_t count, uint32_t wanted,
                               Which which, const PairAt& pair_at) const {
    constexpr uint32_t at_once = Scratch::most_hits / 64;
    for (uint32_t first = 0; first < count; first += at_once) {
      const uint32_t left = count - first < at_once ? count - first : at_once;
      const auto triangles = [&](uint32_t k) { return places_of(pair_at(first + k / 64), k % 64); };
      group.for_each(1, [&](uint32_t) { scratch.hit_count = 0; });
      group.for_each(8 * left, [&](uint32_t k) {
        const GroupPair pair = pair_at(first + k / 8);
        const uint32_t place = 8 * pair.first + k % 8;
        if (pair.first > pair.second) return;
        uint32_t mask = features.overlapping(place, pair.second);
        for (; mask != 0; mask &= mask - 1) {
          const uint32_t n = pbd::lowest_bit(mask);
          if (has_all(flags[place] | flags[8 * pair.second + n], wanted))
            scratch.hits[pbd::append(scratch.hit_count, 1)] = 8 * k + n;
        }
      });
      group.for_each(scratch.hit_count, [&](uint32_t hit) {
        const GroupPair two = triangles(scratch.hits[hit]);
        features.of_two(two.first, two.second, which,
                        [&](FeatureCode code) { check(features.cloth.corners_of(code)); });
      });
    }
  }

  MENISCUS_HD static bool has_all(uint32_t flags, uint32_t wanted) { return (flags & wanted) == wanted; }

  /// Of any of its triangles.
  MENISCUS_HD uint32_t flags_of_group(uint32_t g) const {
    uint32_t word[2];
    __builtin_memcpy(word, __builtin_assume_aligned(flags.data + 8 * g, 8), sizeof word);
    const uint32_t all = word[0] | word[1];
    return (all | all >> 8 | all >> 16 | all >> 24) & 0xff;
  }

  MENISCUS_HD void check(const Corners& corners) const {
    const FeaturePair pair = pair_of(corners, features.cloth.previous, position);
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

  MENISCUS_HD bool nothing_moves(const Corners& corners) const {
    for (uint32_t k = 0; k < 4; ++k)
      if (position[corners.vertex(k)].w != 0) return false;
    return true;
  }
  /// m: what moves by no more than this may do so by the rounding of a zone's motion.
  MENISCUS_HD float rounding(const Corners& corners) const {
    const Vec3 x = position[corners.vertex(0)].xyz();
    return 1e-6f * max_component(max(x, -x));
  }
};

/// What the substep found, for the host; the most of any.
struct NoteCounters {
  View<const uint32_t> counters;
  View<uint32_t> found;

  MENISCUS_HD void operator()(uint32_t k) const {
    if (found[k] < counters[k]) found[k] = counters[k];
  }
};

}  // namespace meniscus::cloth::self_contact_kernels
