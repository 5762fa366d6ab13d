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
enum Again : uint32_t { others = 1, own_sheet = 2 };

/// Flags groups: those with a vertex that is not where it was foreseen, and those that are squeezed, must be
/// looked at with all others. Everywhere else, pairs that are no contacts were foreseen further apart than
/// the tolerances of both. Groups with a normal that has left their cone must be looked at with those that
/// they were one sheet with.
struct FlagGroups {
  pbd::SurfaceTreeView tree;
  View<const Part> parts;
  View<const Vec4> foreseen, position;      // by vertex
  View<const Vec4> cones;                   // by group
  View<const uint32_t> squeezed, counters;  // by group
  View<uint32_t> flags;
  uint32_t round;

  MENISCUS_HD void operator()(uint32_t g) const {
    if (round > 0 && counters[crossings + round - 1] == 0) return;
    constexpr float leeway = 0.13f;  // rad: two groups' normals are then still within a half-space
    const Vec4 cone = cones[g];
    const float least = cosf(pbd::min(3.1415927f, cone.w + leeway));
    uint32_t flag = squeezed[g] != 0 ? uint32_t{others} : 0;
    for (uint32_t k = 0; k < 8; ++k) {
      const SurfaceTriangle t = tree.triangles[8 * g + k];
      if (t.a == no_index) continue;
      const float tolerance = parts[t.part].tolerance;
      if (is_off(t.a, tolerance) || is_off(t.b, tolerance) || is_off(t.c, tolerance)) flag |= others;
      const Vec3 a = position[t.a].xyz(), n = cross(position[t.b].xyz() - a, position[t.c].xyz() - a);
      if (dot(n, cone.xyz()) < least * length(n)) flag |= own_sheet;
    }
    flags[g] = flag;
  }

  MENISCUS_HD bool is_off(uint32_t v, float tolerance) const {
    const Vec3 off = position[v].xyz() - foreseen[v].xyz();
    return dot(off, off) > tolerance * tolerance;
  }
};

/// Looks for pairs that would pass through one another, and limits their vertices' motion: at first to the
/// part before they meet; if that makes others meet, in the next round to so little that the two cannot; then
/// to none.
struct FindCrossings {
  FeaturePairs pairs;
  ContactList list;
  View<const Vec4> position;  // by vertex
  View<const uint32_t> flags;
  View<uint32_t> limit;  // by vertex: bits of the part of its motion that is left to it
  uint32_t contact_count, round;
  float least;  // m: what is nearer hardly comes nearer still, as it would soon be lost in rounding

  MENISCUS_HD void operator()(uint32_t n) const {
    if (round > 0 && list.counters[crossings + round - 1] == 0) return;
    if (n < contact_count) {
      if (n < list.count()) check(list.corners[n], list.push[n].w);
      return;
    }
    const uint32_t place = n - contact_count;
    const uint32_t own = flags[place / 8];
    pairs.of_place(
        place,
        [&](uint32_t entry) {
          const uint32_t flag = own | flags[entry & ~in_one_sheet];
          return (flag & (entry & in_one_sheet ? own_sheet : others)) != 0;
        },
        [&](FeatureCode code) { check(pairs.cloth.corners_of(code), -1); });
  }

  /// `distance`: at the start, where it is known.
  MENISCUS_HD void check(const Corners& corners, float distance) const {
    const FeaturePair pair = pair_of(corners, pairs.cloth.previous, position);
    const float motion = relative_motion(pair);
    if (distance < 0) distance = nearest(pair, 0).distance;
    const float gap = pbd::min(0.9f * distance, pbd::max(0.1f * distance, least));
    if (motion < distance - gap || distance <= 0) return;
    const float t = time_of_nearness(pair, distance, motion, gap);
    if (t > 1) return;
    pbd::atomic_add(list.counters[crossings + round], 1);
    for (uint32_t k = 0; k < 4; ++k) {
      const float part = round == 0   ? 0.9f * t
                         : round == 1 ? little(pair.motion[k], 0.45f * (distance - gap))
                                      : 0;
      uint32_t bits;
      __builtin_memcpy(&bits, &part, sizeof bits);  // of numbers from 0 to 1 the order is that of their bits
      pbd::atomic_min(limit[corners.vertex(k)], bits);
    }
  }

  MENISCUS_HD static float little(Vec3 motion, float way) {
    return pbd::min(1, way / pbd::max(length(motion), 1e-20f));
  }
};

/// Takes vertices back to the part of their motion that is left to them.
struct HoldBack {
  View<const Vec4> previous;
  View<Vec4> position, moved;
  View<uint32_t> limit, counters;
  uint32_t round;

  MENISCUS_HD void operator()(uint32_t v) const {
    if (counters[crossings + round] == 0 || limit[v] == no_index) return;
    float part;
    const uint32_t bits = limit[v];
    __builtin_memcpy(&part, &bits, sizeof part);
    limit[v] = no_index;
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
