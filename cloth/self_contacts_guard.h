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

/// A vertex's limit: bits of the part of its motion that is left to it, or what is greater than those of 1.
inline constexpr uint32_t bits_of_one = 0x3f800000, held_back = 1u << 31;

/// Flags triangles: those with a vertex that is not where it was foreseen, and those of groups that are
/// squeezed, must be looked at with all others. Everywhere else, pairs that are no contacts were foreseen
/// further apart than the tolerances of both. Where a triangle's normal has left its group's cone, the sheet
/// around is looked at as well.
struct FlagTriangles {
  pbd::SurfaceTreeView tree;
  View<const Part> parts;
  View<const Vec4> foreseen, position;  // by vertex
  View<const uint32_t> limit;           // by vertex
  View<const uint32_t> squeezed;        // by group
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
  MENISCUS_HD bool has_changed(uint32_t v) const { return limit[v] == held_back + round - 1; }
};

/// Looks for pairs that would pass through one another, and limits their vertices' motion: at first to the
/// part before they meet; if that makes others meet, in the next round to so little that the two cannot; then
/// to none. Nothing leaves the boxes that the candidates were found by, so that no others need be looked for,
/// but among what was left out there.
struct FindCrossings {
  FeaturePairs features;
  View<const FeatureCode> candidate_list;
  GroupPairs pairs;
  SheetViews sheets;
  View<const Vec4> position;  // by vertex
  View<const uint8_t> flags;  // by place
  View<uint32_t> limit, counters;
  uint32_t round, stride;
  /// m: what is nearer hardly comes nearer still, and what is nearer than a tenth of it does not at all, as
  /// it would soon be lost in rounding.
  float least;

  MENISCUS_HD void operator()(uint32_t thread) const {
    if (round > 0 && counters[crossings + round - 1] == 0) return;
    const uint32_t found = listed(candidate_list, counters[candidates]), others = 8 * pairs.count(),
                   places = 8 * sheets.smooth.count;
    for (uint32_t n = thread; n < found; n += stride) check_candidate(load(candidate_list, n));
    for (uint32_t n = thread; n < others; n += stride) check_left_out(pairs.list[n / 8], n % 8);
    for (uint32_t n = thread; n < places; n += stride) check_sheet(n);
  }

  MENISCUS_HD void check_candidate(FeatureCode code) const {
    const uint32_t flag = flags[code.first_place()] | flags[code.second_place()];
    if (flag & changed && (flag & others || code.is_contact())) check(features.cloth.corners_of(code));
  }

  MENISCUS_HD void check_left_out(GroupPair pair, uint32_t k) const {
    const uint32_t place = 8 * pair.first + k;
    const View<const uint32_t>& rough = features.cloth.rough;
    if (rough[pair.first] && rough[pair.second]) return;
    const uint32_t flag = flags[place] | flags_of_group(pair.second);
    if (flag & changed && flag & others) check_all(place, pair.second, Which::left_out);
  }
  /// With all that was left out as its sheet was smooth.
  MENISCUS_HD void check_sheet(uint32_t place) const {
    const uint32_t g = place / 8;
    if (!sheets.folded[g] || !sheets.smooth[g]) return;
    for (uint32_t n = sheets.neighbour_start[g]; n < sheets.neighbour_start[g + 1]; ++n) {
      const uint32_t other = sheets.neighbours[n];
      if (other >= g && (flags[place] | flags_of_group(other)) & changed) check_all(place, other, Which::all);
    }
  }
  MENISCUS_HD void check_all(uint32_t place, uint32_t group, Which which) const {
    features.of_place(place, group, which, [&](FeatureCode code) { check(features.cloth.corners_of(code)); });
  }

  /// Of any of its triangles.
  MENISCUS_HD uint32_t flags_of_group(uint32_t g) const {
    uint32_t word[2];
    __builtin_memcpy(word, __builtin_assume_aligned(flags.data + 8 * g, 8), sizeof word);
    const uint32_t all = word[0] | word[1];
    return (all | all >> 8 | all >> 16 | all >> 24) & 0xff;
  }

  MENISCUS_HD void check(const Corners& corners) const {
    const FeaturePair pair = pair_of(corners, features.cloth.previous, position);
    const float motion = relative_motion(pair), distance = nearest(pair, 0).distance;
    if (motion == 0 || distance <= 0) return;
    const bool nearly_lost = distance < 0.1f * least;
    const float gap =
        nearly_lost ? 0.5f * distance : pbd::min(0.9f * distance, pbd::max(0.1f * distance, least));
    const float t = motion < distance - gap ? 2 : time_of_nearness(pair, gap);
    if (t > 1 && !(nearly_lost && nearest(pair, 1).distance < distance)) return;
    pbd::atomic_add(counters[crossings + round], 1);
    for (uint32_t k = 0; k < 4; ++k) {
      const float part = round > 1 || nearly_lost ? 0
                         : round == 0             ? 0.9f * t
                                                  : little(pair.motion[k], 0.45f * (distance - gap));
      uint32_t bits;
      __builtin_memcpy(&bits, &part, sizeof bits);  // of numbers from 0 to 1 the order is that of their bits
      pbd::atomic_min(limit[corners.vertex(k)], bits);
    }
  }

  MENISCUS_HD static float little(Vec3 motion, float way) {
    return pbd::min(1, way / pbd::max(length(motion), 1e-20f));
  }
};

/// Takes vertices back to the part of their motion that is left to them. Where the last round there is still
/// finds something, all stay where they were, as nothing had passed through there.
struct HoldBack {
  View<const Vec4> previous;
  View<Vec4> position, moved;
  View<uint32_t> limit, counters;
  uint32_t round;

  MENISCUS_HD void operator()(uint32_t v) const {
    if (counters[crossings + round] == 0) return;
    const uint32_t bits = round + 1 < most_rounds ? limit[v] : 0;
    if (bits > bits_of_one) return;
    float part;
    __builtin_memcpy(&part, &bits, sizeof part);
    limit[v] = held_back + round;
    const Vec4 x = position[v];
    if (x.w == 0) return;
    const Vec3 from = previous[v].xyz(), back = from + part * (x.xyz() - from);
    position[v] = pbd::with_w(back, x.w);
    moved[v] = pbd::with_w(moved[v].xyz() + (back - x.xyz()), moved[v].w);
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
