// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The CCD fail-safe of cloth-to-cloth contacts: nothing passes through, whatever error the solve has left.
#pragma once

#include "cloth/self_contact/cull.h"
#include "cloth/self_contact/features.h"
#include "cloth/self_contact/folds.h"
#include "cloth/self_contact/tuning.h"

namespace meniscus::cloth::self_contact_kernels {

/// Clamps each vertex to the surroundings of its predicted motion and to the place that was searched. Also
/// records how far the vertex strays from its predicted motion, in its frame. The next substep allows for
/// that.
struct Contain {
  View<const Vec4> previous;  // by vertex
  View<const uint32_t> vertex_piece;
  MotionBounds kept;
  Frames frames;
  Surroundings around;  // forgotten here
  View<Vec4> foreseen;  // afterwards: see RolledBack
  View<Vec4> position, accumulated_delta;
  View<float> strayed;
  OwnMotion own_motion;
  View<uint32_t> all_counters;
  uint32_t vertices_of_world;

  MENISCUS_HD void operator()(uint32_t v) const {
    const View<uint32_t> counters = counters_of(all_counters, v / vertices_of_world);
    if (v % vertices_of_world == 0) grow_old(counters);
    const uint32_t rows = frames.of_piece.count + frames.motion.count;
    for (uint32_t row = v; row < rows; row += vertex_piece.count) around.clear(row);
    contain(v, counters);
    own_motion.begin(v, position[v]);
  }

 private:
  MENISCUS_HD void contain(uint32_t v, View<uint32_t> counters) const {
    if (vertex_piece[v] == no_index) return;
    const Vec4 x = position[v], ahead = foreseen[v];
    const Vec3 from = previous[v].xyz() + frames.at(v).xyz(), to = ahead.xyz();
    const Vec3 lower = min(from, to), upper = max(from, to);
    strayed[v] = pbd::max(0, max_component(max(x.xyz() - upper, lower - x.xyz())));
    const RolledBack taken{foreseen, counters};
    taken.begin(v);
    if (x.w == 0) return;
    const Aabb box = pbd::inflated({lower, upper}, ahead.w);
    const Vec3 inside = kept.inside(v, max(box.lower, min(box.upper, x.xyz())));
    if (inside == x.xyz()) return;
    taken.add(v, x.xyz() - inside);
    position[v] = pbd::with_w(inside, x.w);
    accumulated_delta[v] = pbd::shifted(accumulated_delta[v], inside - x.xyz());
  }
  /// Expired lists have been made again.
  MENISCUS_HD static void grow_old(View<uint32_t> counters) {
    counters[age] = counters[expired] != 0 ? 1 : counters[age] + 1;
    counters[expired] = counters[long_expired] = 0;
  }
};

/// Working memory of a group of threads that sums up what groups of triangles have lost.
struct LostScratch {
  static constexpr uint32_t groups = 64;

  Vec3 positional_impulse[groups];  // kg·m
  float mass[groups];               // kg
  uint32_t piece[groups];
};

/// Sums up the momentum of vertices that were rolled back, and the mass of each piece.
struct SumLost {
  using Scratch = LostScratch;

  ClothState cloth;
  View<const Vec4> taken;  // by vertex, m: see RolledBack
  PieceSums sums;
  View<const uint32_t> counters;

  template <class Group>
  MENISCUS_HD void operator()(const Group& group, Scratch& scratch, uint32_t n) const {
    const GroupRange range(n, Scratch::groups, cloth.of_world.groups);
    if (counters_of(counters, range.world)[lost] == 0) return;
    const uint32_t first = range.first, count = range.count;
    group.for_each(count, [&](uint32_t k) { sum(scratch, k, first + k); });
    // The first group of each piece adds up the groups of that piece which follow it.
    group.for_each(count, [&](uint32_t k) {
      const uint32_t piece = scratch.piece[k];
      if (k > 0 && scratch.piece[k - 1] == piece) return;
      Vec3 positional_impulse{0, 0, 0};
      float mass = 0;
      for (uint32_t other = k; other < count && scratch.piece[other] == piece; ++other) {
        positional_impulse += scratch.positional_impulse[other];
        mass += scratch.mass[other];
      }
      sums.add(piece, positional_impulse, mass);
    });
  }

 private:
  /// Each vertex belongs to one of its triangles.
  MENISCUS_HD void sum(Scratch& scratch, uint32_t k, uint32_t g) const {
    Vec3 positional_impulse{0, 0, 0};
    float mass = 0;
    for (uint32_t place = 8 * g; place < 8 * g + 8; ++place) {
      const SurfaceTriangle t = load(cloth.tree.triangles, place);
      for (uint32_t corner = 0; corner < 3; ++corner) {
        if (!(cloth.features[place] & owns_vertex << corner)) continue;
        const uint32_t v = corner_of(t, corner);
        const float w = cloth.position[v].w, m = w > 0 ? 1 / w : 0.0f;
        positional_impulse += m * taken[v].xyz();
        mass += m;
      }
    }
    scratch.positional_impulse[k] = positional_impulse;
    scratch.mass[k] = mass;
    scratch.piece[k] = cloth.tree.triangles[8 * g].piece;
  }
};

/// Transfers the momentum of vertices that were rolled back to all vertices of their piece, whose positions
/// do not change. This causes no relative motion within the piece. Given only to the vertices around, the
/// momentum kept crumpled cloth stretched. Also records, by world, the greatest counters of any substep, up
/// to the first one whose lists had no room, and the number of substeps in which the rounds did not suffice.
struct TransferPush {
  View<const uint32_t> vertex_piece;
  View<const Vec4> position;     // by vertex
  View<Vec4> accumulated_delta;  // by vertex
  PieceSums sums;
  View<const uint32_t> counters;  // of all worlds
  View<uint32_t> found;
  uint32_t vertices_of_world;

  /// Runs for each vertex and for each counter.
  MENISCUS_HD void operator()(uint32_t v) const {
    if (v < counters.count) record(v, counters_of(counters, v / counter_count));
    if (v >= vertex_piece.count || counters_of(counters, v / vertices_of_world)[lost] == 0) return;
    if (vertex_piece[v] == no_index || position[v].w == 0) return;
    accumulated_delta[v] = pbd::shifted(accumulated_delta[v], sums.displacement(vertex_piece[v]));
  }

 private:
  MENISCUS_HD void record(uint32_t k, View<const uint32_t> own) const {
    if (own[overflowed] == 0 && found[k] < counters[k]) found[k] = counters[k];
    if (k % counter_count == given_up && own[crossings + most_rounds - 1] != 0) ++found[k];
  }
};

/// The greatest counters of any world, for the host.
struct NoteFound {
  View<const uint32_t> by_world;
  View<uint32_t> found;

  MENISCUS_HD void operator()(uint32_t k) const {
    uint32_t& greatest = found[k % counter_count];
    if (pbd::atomic_load(greatest) < by_world[k]) pbd::atomic_max(greatest, by_world[k]);
  }
};

/// Working memory for the pairs of two groups of triangles: pairs of triangles, by number, and pairs of
/// features.
struct CrossingScratch {
  static constexpr uint32_t hits_of_two = 64;

  CullScratch cull;
  uint32_t hits[hits_of_two];
  FeatureCode codes[PairsOfTwo::most * hits_of_two];
  uint32_t hit_count, code_count;
};

/// Finds pairs that would pass through one another, and unites their vertices in one impact zone. If that
/// makes other pairs meet, these join in the next round. All vertices stay inside the place that was
/// searched. So no further pairs need to be searched for, except in sheets that are no longer smooth
/// (FindFolds).
struct FindCrossings {
  using Scratch = CrossingScratch;

  ClothState cloth;
  View<const FeatureCode> candidate_list;
  SheetViews sheets;
  ImpactZones impact_zones;
  OwnMotion own_motion;
  Folds folds;
  uint32_t worlds;
  uint32_t round;
  uint32_t stride;  // groups of threads for each world
  /// m: a pair that is nearer than this hardly comes nearer still. A pair that is nearer than a tenth of it
  /// does not approach at all, as its distance would soon be lost in rounding.
  float least;

  template <class Group>
  MENISCUS_HD void operator()(const Group& group, Scratch& scratch, uint32_t n) const {
    const uint32_t world = n / stride, own = n % stride;
    const View<uint32_t> counters = folds.counters_in(world);
    if (!is_round_needed(counters, round)) return;
    forget_sums(group, world, own);
    const View<const FeatureCode> codes = part_of(candidate_list, world, candidate_list.count / worlds);
    Cull(listed(codes, counters[candidates]), own, stride)
        .run(
            group, scratch.cull, [&](uint32_t k) { return may_cross(load(codes, k)); },
            [&](uint32_t k) { check(counters, cloth.corners_of(load(codes, k))); });
    check_folds(group, scratch, world, own);
  }

 private:
  template <class Group>
  MENISCUS_HD void forget_sums(const Group& group, uint32_t world, uint32_t n) const {
    constexpr uint32_t together = 128;
    const uint32_t all = cloth.of_world.vertices, begin = world * all;
    for (uint32_t first = together * n; first < all; first += together * stride)
      group.for_each(all - first < together ? all - first : together,
                     [&](uint32_t k) { impact_zones.forget_sums(begin + first + k); });
  }

  /// Checks the pairs that were left out because their sheets were smooth. They are few, and many threads
  /// share them: each group of threads takes every 32nd neighbour of a sheet's central group.
  template <class Group>
  MENISCUS_HD void check_folds(const Group& group, Scratch& scratch, uint32_t world, uint32_t n) const {
    constexpr uint32_t groups_of_threads = 32;
    const View<uint32_t> counters = folds.counters_in(world);
    for (uint32_t item = n; item < groups_of_threads * counters[folded_sheets]; item += stride) {
      const uint32_t g = folds.list_in(world)[item / groups_of_threads], end = sheets.neighbour_start[g + 1];
      for (uint32_t k = sheets.neighbour_start[g] + item % groups_of_threads; k < end; k += groups_of_threads)
        check_two(group, scratch, counters, g, sheets.neighbours[k]);
    }
  }

  template <class Group>
  MENISCUS_HD void check_two(const Group& group, Scratch& scratch, View<uint32_t> counters, uint32_t g,
                             uint32_t other) const {
    if (other < g || !(folds.has_changed(g, round) || folds.has_changed(other, round))) return;
    group.for_each(1, [&](uint32_t) { scratch.hit_count = scratch.code_count = 0; });
    group.for_each(8, [&](uint32_t k) {
      uint32_t mask = overlapping(cloth.tree, 8 * g + k, other);
      for (; mask != 0; mask &= mask - 1)
        scratch.hits[pbd::append(scratch.hit_count, 1)] = 8 * k + pbd::lowest_bit(mask);
    });
    group.for_each(scratch.hit_count, [&](uint32_t n) {
      const GroupPair two = places_of({g, other}, scratch.hits[n]);
      const PairsOfTwo found(own_features(cloth, two.first), own_features(cloth, two.second));
      uint32_t place = pbd::append(scratch.code_count, pbd::bit_count(found.mask));
      for (uint32_t left = found.mask; left != 0; left &= left - 1)
        scratch.codes[place++] = found.code(two, pbd::lowest_bit(left));
    });
    group.for_each(scratch.code_count, [&](uint32_t n) {
      if (may_cross(scratch.codes[n])) check(counters, cloth.corners_of(scratch.codes[n]));
    });
  }

  /// A quick test. Later rounds skip unchanged pairs, which were checked before. The states of their groups
  /// tell most of this.
  MENISCUS_HD bool may_cross(FeatureCode code) const {
    if (!folds.has_changed(code.first_place() / 8, round) &&
        !folds.has_changed(code.second_place() / 8, round))
      return false;
    const Corners corners = cloth.corners_of(code);
    return (round == 0 || has_changed(corners)) && !(pbd::least_gap(pair_of(corners)) > least);
  }
  MENISCUS_HD FeaturePair pair_of(const Corners& corners) const {
    return self_contact_kernels::pair_of(corners, cloth.previous, cloth.position);
  }
  MENISCUS_HD void check(View<uint32_t> counters, const Corners& corners) const {
    const FeaturePair pair = pair_of(corners);
    const float motion = relative_motion(pair);
    const Nearest at_start = nearest(pair, 0);
    const float distance = at_start.distance;
    if (motion == 0 || distance <= 0) return;
    const bool nearly_lost = distance < self_contact_tuning::nearly_lost * least;
    const float gap = nearly_lost ? self_contact_tuning::lost_gap * distance
                                  : pbd::min(self_contact_tuning::gap * distance, least);
    own_motion.part(corners, pair, cloth.previous, cloth.frames, at_start, gap);
    const float t = motion < distance - gap ? 2 : time_of_nearness(pair, gap);
    if (t > 1 && !(nearly_lost && nearest(pair, 1).distance < distance)) return;
    if (nothing_moves(corners)) return;
    pbd::atomic_add(counters[crossings + round], 1);
    if (cloth.frames.differ(corners.vertex(0), corners.vertex(3))) pbd::atomic_max(counters[frames_meet], 1);
    const bool holds = nearly_lost || motion < rounding(corners) || have_parted(corners);
    if (holds) own_motion.hold(corners);
    impact_zones.unite(corners, round, holds);
  }

  /// Whether a vertex has moved in the last round.
  MENISCUS_HD bool has_changed(const Corners& corners) const {
    for (uint32_t k = 0; k < 4; ++k)
      if (impact_zones.has_moved(corners.vertex(k), round)) return true;
    return false;
  }
  /// Whether all four have been moved by their own motion. Where they still meet, it is by rounding.
  MENISCUS_HD bool have_parted(const Corners& corners) const {
    for (uint32_t k = 0; k < 4; ++k)
      if (!impact_zones.has_parted(corners.vertex(k))) return false;
    return true;
  }
  MENISCUS_HD bool nothing_moves(const Corners& corners) const {
    for (uint32_t k = 0; k < 4; ++k)
      if (cloth.position[corners.vertex(k)].w != 0) return false;
    return true;
  }
  /// m: a motion up to this size may come from the rounding of a zone's motion.
  MENISCUS_HD float rounding(const Corners& corners) const {
    const Vec3 x = cloth.position[corners.vertex(0)].xyz();
    return self_contact_tuning::rounding * max_component(max(x, -x));
  }
};

}  // namespace meniscus::cloth::self_contact_kernels
