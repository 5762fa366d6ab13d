// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Pairs of groups of triangles that may touch, found with the tree.
#pragma once

#include "cloth/self_contact/candidate_lifetime.h"
#include "cloth/self_contact/features.h"
#include "cloth/self_contact/tuning.h"

namespace meniscus::cloth::self_contact_kernels {

/// Working memory for the cones of sixteen groups of eight triangles.
struct ConeScratch {
  static constexpr uint32_t groups = 16, triangles = 8 * groups;

  Vec3 before[triangles], after[triangles];  // normals
  float longest2[triangles];                 // m²: of the edges
  Vec3 axis[groups];
};

/// Fits a cone around the normals of a group's triangles, before and after its motion.
///
/// Where cloth is smooth, its vertices keep it apart from other cloth, and its edges need no contacts. With θ
/// the angle that an edge of length L is bent by, the cloth rises by Lθ/4 between the ends of the edge.
struct FitCones {
  using Scratch = ConeScratch;

  Listing listing;
  pbd::SurfaceTreeView tree;
  View<const PieceProperties> pieces;
  View<const Vec4> previous, position;
  View<Vec4> cones;
  View<uint32_t> rough;
  uint32_t groups_of_world;

  /// Runs for up to 16 groups.
  template <class Group>
  MENISCUS_HD void operator()(const Group& group, Scratch& scratch, uint32_t n) const {
    const GroupRange range(n, Scratch::groups, groups_of_world);
    if (!listing.wanted(range.world)) return;
    const uint32_t first = range.first, count = range.count;
    group.for_each(8 * count, [&](uint32_t k) {
      const SurfaceTriangle t = load(tree.triangles, 8 * first + k);
      scratch.longest2[k] = 0;
      scratch.before[k] = normal(previous, t, scratch.longest2[k]);
      scratch.after[k] = normal(position, t, scratch.longest2[k]);
    });
    group.for_each(count, [&](uint32_t g) {
      Vec3 sum{0, 0, 0};
      for (uint32_t k = 8 * g; k < 8 * g + 8; ++k) sum += scratch.before[k] + scratch.after[k];
      scratch.axis[g] = normalized_or(sum, {0, 0, 0});
    });
    group.for_each(count, [&](uint32_t g) { fit(scratch, first, g); });
  }

 private:
  MENISCUS_HD void fit(const Scratch& scratch, uint32_t first, uint32_t g) const {
    const Vec3 axis = scratch.axis[g];
    float least = 1, longest2 = 0;
    for (uint32_t k = 8 * g; k < 8 * g + 8; ++k) {
      if (tree.triangles[8 * first + k].a == no_index) continue;
      least = pbd::min(least, pbd::min(dot(axis, scratch.before[k]), dot(axis, scratch.after[k])));
      longest2 = pbd::max(longest2, scratch.longest2[k]);
    }
    const float angle = acosf(pbd::clamp(least, -1, 1));
    cones[first + g] = pbd::with_w(axis, angle);
    rough[first + g] = angle * sqrtf(longest2) >
                       self_contact_tuning::rough * pieces[tree.triangles[8 * (first + g)].piece].thickness;
  }

  /// The normal of a triangle. Also updates the square of the longest edge so far.
  MENISCUS_HD static Vec3 normal(View<const Vec4> x, const SurfaceTriangle& t, float& longest2) {
    if (t.a == no_index) return {0, 0, 0};
    const Vec3 a = x[t.a].xyz(), ab = x[t.b].xyz() - a, ac = x[t.c].xyz() - a, bc = ac - ab;
    longest2 = pbd::max(longest2, pbd::max(dot(ab, ab), pbd::max(dot(ac, ac), dot(bc, bc))));
    return normalized_or(cross(ab, ac), {0, 0, 0});
  }
};

/// Working memory for eight groups that search for overlaps: boxes that each hold 512 groups, and boxes that
/// each hold eight, by number.
struct OverlapScratch {
  static constexpr uint32_t boxes = 128;

  uint32_t tops[boxes], eights[8 * boxes];
  uint32_t top_count, count;
};

/// Lists the pairs of groups whose boxes overlap, for eight groups at a time. It goes through a number of the
/// tree's boxes at once. It finds the boxes of eight groups below them that overlap the common box of its own
/// eight, then the groups in these. Large trees start from boxes at a higher level. Neighbours in the
/// material always overlap; in smooth sheets they are left out.
struct FindGroups {
  using Scratch = OverlapScratch;

  Listing listing;
  pbd::SurfaceTreeView tree;
  View<const PieceProperties> pieces;
  View<const uint32_t> cell_of;  // by piece, see ChooseFrames
  SheetViews sheets;
  GroupPairs all_pairs;

  /// Runs for the groups from 8 n on, paired with themselves and later groups of their world.
  template <class Group>
  MENISCUS_HD void operator()(const Group& group, Scratch& scratch, uint32_t n) const {
    const uint32_t world = n / tree.groups_of_world(1);
    if (!listing.wanted(world)) return;
    const GroupPairs pairs = all_pairs.of(world, all_pairs.list.count / tree.worlds);
    group.for_each(8, [&](uint32_t k) { note_smoothness(8 * n + k); });
    const bool large = tree.levels > 4;
    const uint32_t each = large                 ? tree.boxes[4] / tree.worlds
                          : eights_have_boxes() ? tree.groups_of_world(2)
                                                : 1;
    const uint32_t end = (world + 1) * each;
    uint32_t first = large ? n / 64 : eights_have_boxes() ? n / 8 : world;
    for (; first < end; first += Scratch::boxes) {
      const uint32_t boxes = end - first < Scratch::boxes ? end - first : Scratch::boxes;
      if (large)
        search_below(group, scratch, pairs, n, first, boxes);
      else
        pair_up_all(group, scratch, pairs, n, boxes, [&](uint32_t k) { return first + k; });
    }
  }

 private:
  /// Boxes of level 4 from `first` on.
  template <class Group>
  MENISCUS_HD void search_below(const Group& group, Scratch& scratch, const GroupPairs& pairs, uint32_t n,
                                uint32_t first, uint32_t boxes) const {
    group.for_each(1, [&](uint32_t) { scratch.top_count = 0; });
    group.for_each(boxes, [&](uint32_t k) {
      if (boxes_in_time(pairs).overlap(4, first + k, 2, n))
        scratch.tops[pbd::append(scratch.top_count, 1)] = first + k;
    });
    const uint32_t below = 8 * scratch.top_count;
    for (uint32_t done = 0; done < below; done += Scratch::boxes) {
      const uint32_t left = below - done < Scratch::boxes ? below - done : Scratch::boxes;
      pair_up_all(group, scratch, pairs, n, left,
                  [&](uint32_t k) { return 8 * scratch.tops[(done + k) / 8] + k % 8; });
    }
  }
  /// `count` boxes of the level above the boxes of eight groups.
  template <class Group, class BoxAt>
  MENISCUS_HD void pair_up_all(const Group& group, Scratch& scratch, const GroupPairs& pairs, uint32_t n,
                               uint32_t count, const BoxAt& box_at) const {
    group.for_each(1, [&](uint32_t) { scratch.count = 0; });
    group.for_each(count, [&](uint32_t k) { find_eights(scratch, pairs, n, box_at(k)); });
    const uint32_t found = scratch.count;
    group.for_each(8 * found, [&](uint32_t k) { pair_up(pairs, 8 * n + k % 8, scratch.eights[k / 8]); });
  }
  MENISCUS_HD BoxesInTime boxes_in_time(const GroupPairs& pairs) const {
    return {tree, pairs.counters[several_frames] != 0};
  }
  MENISCUS_HD bool eights_have_boxes() const { return tree.levels > 2; }

  MENISCUS_HD void note_smoothness(uint32_t g) const {
    if (g >= sheets.smooth.count) return;
    sheets.smooth[g] = sheets.is_smooth(g);
  }

  /// Where eights have no boxes, a world has few, and `box` is the world.
  MENISCUS_HD void find_eights(Scratch& scratch, const GroupPairs& pairs, uint32_t n, uint32_t box) const {
    if (tree.levels > 3 && !boxes_in_time(pairs).overlap(3, box, 2, n)) return;
    const uint32_t eights = tree.groups_of_world(1);
    uint32_t mask = eights_have_boxes() ? boxes_in_time(pairs).mask(2, box, 2, n) : (1u << eights) - 1;
    const uint32_t begin = box * (eights_have_boxes() ? 8 : eights);
    for (; mask != 0; mask &= mask - 1) {
      const uint32_t eight = begin + pbd::lowest_bit(mask);
      if (eight >= n) scratch.eights[pbd::append(scratch.count, 1)] = eight;
    }
  }

  MENISCUS_HD void pair_up(const GroupPairs& pairs, uint32_t g, uint32_t eight) const {
    uint32_t mask = boxes_in_time(pairs).mask(1, eight, 1, g);
    if (eight == g / 8) mask &= ~0u << g % 8;
    if (mask == 0) return;
    const uint32_t piece = tree.triangles[8 * g].piece;
    Appending<GroupPair> found(pairs.list, pairs.counters[group_pairs]);
    for (; mask != 0; mask &= mask - 1) {
      const uint32_t other = 8 * eight + pbd::lowest_bit(mask);
      const uint32_t others_piece = tree.triangles[8 * other].piece;
      if (!may_touch(piece, others_piece) || sheets.has_in_sheet(g, other)) continue;
      found.add({g, other});
      if (cell_of[piece] != cell_of[others_piece]) pbd::atomic_max(pairs.counters[cells_meet], 1);
    }
    found.flush();
  }

  MENISCUS_HD bool may_touch(uint32_t p, uint32_t q) const {
    const PieceProperties a = pieces[p], b = pieces[q];
    if (p == q) return a.self != 0;
    return (a.filter_groups & b.filter_mask) != 0 && (b.filter_groups & a.filter_mask) != 0;
  }
};

}  // namespace meniscus::cloth::self_contact_kernels
