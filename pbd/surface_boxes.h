// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The tree of boxes over a surface's triangles as kernels see it. It has no pointers: triangles stand in an
// order in which those that are near in the material are near, box b of level 0 is triangle b's, and box b of
// a higher level holds the boxes 8b to 8b + 7 of the level below.
#pragma once

#include <cstdint>

#include "pbd/contacts.h"
#include "pbd/device/eight.h"
#include "pbd/device/scalar.h"
#include "pbd/surface.h"

namespace meniscus::pbd {

inline constexpr Aabb empty_box{{3e38f, 3e38f, 3e38f}, {-3e38f, -3e38f, -3e38f}};

MENISCUS_HD inline Aabb joined(const Aabb& a, const Aabb& b) {
  return {min(a.lower, b.lower), max(a.upper, b.upper)};
}
MENISCUS_HD inline Aabb inflated(const Aabb& box, float by) {
  const Vec3 margin{by, by, by};
  return {box.lower - margin, box.upper + margin};
}
MENISCUS_HD inline bool overlap(const Aabb& a, const Aabb& b) {
  return a.lower.x <= b.upper.x && b.lower.x <= a.upper.x && a.lower.y <= b.upper.y &&
         b.lower.y <= a.upper.y && a.lower.z <= b.upper.z && b.lower.z <= a.upper.z;
}

/// Eight boxes side by side, so that one test sees them all.
struct alignas(64) BoxGroup {
  static constexpr uint32_t size = 8;

  float lower[3][size], upper[3][size];

  MENISCUS_HD void set(uint32_t k, const Aabb& box) {
    lower[0][k] = box.lower.x, lower[1][k] = box.lower.y, lower[2][k] = box.lower.z;
    upper[0][k] = box.upper.x, upper[1][k] = box.upper.y, upper[2][k] = box.upper.z;
  }
  MENISCUS_HD Aabb box(uint32_t k) const {
    return {{lower[0][k], lower[1][k], lower[2][k]}, {upper[0][k], upper[1][k], upper[2][k]}};
  }
};

/// Bit k is set where box k overlaps.
MENISCUS_HD inline uint32_t overlap_mask(const BoxGroup& group, const Aabb& box) {
  const uint32_t x = at_most_mask(group.lower[0], box.upper.x) & at_least_mask(group.upper[0], box.lower.x);
  const uint32_t y = at_most_mask(group.lower[1], box.upper.y) & at_least_mask(group.upper[1], box.lower.y);
  const uint32_t z = at_most_mask(group.lower[2], box.upper.z) & at_least_mask(group.upper[2], box.lower.z);
  return x & y & z;
}

struct SurfaceTreeView {
  static constexpr uint32_t most_levels = 8;  // so that a descent's open boxes fit into 64 bits

  View<BoxGroup> groups;        ///< of all levels
  uint32_t start[most_levels];  ///< of each level, its first group
  uint32_t boxes[most_levels];  ///< of each level; its last group is filled up with empty ones
  uint32_t levels = 0;
  View<const SurfaceTriangle> triangles;  ///< in the tree's order; a is no_index for what fills up a group

  MENISCUS_HD BoxGroup& group(uint32_t level, uint32_t g) const { return groups[start[level] + g]; }
  MENISCUS_HD Aabb box(uint32_t level, uint32_t b) const { return group(level, b / 8).box(b % 8); }
  MENISCUS_HD uint32_t groups_of(uint32_t level) const { return (boxes[level] + 7) / 8; }
};

/// Calls visit(b) for each box b ≥ `from` of a level that overlaps, in ascending order; level 0 has the
/// triangles' boxes. Of all that is below those boxes of the highest level, in its group `root`, whose bits
/// are set in `open`: they overlap.
template <class Visit>
MENISCUS_HD void visit_overlaps(const SurfaceTreeView& tree, uint32_t root, uint64_t open, const Aabb& box,
                                uint32_t level, uint32_t from, const Visit& visit) {
  const uint32_t top = tree.levels - 1;
  uint32_t at = top, group = root;
  for (;;) {  // `open` has eight bits a level, the present one lowest
    const uint32_t here = static_cast<uint32_t>(open & 0xff);
    if (here == 0) {
      if (at == top) break;
      open >>= 8;
      group >>= 3;
      ++at;
      continue;
    }
    open &= open - 1;
    const uint32_t child = 8 * group + lowest_bit(here);
    if (((child + 1) << 3 * (at - level)) <= from) continue;
    if (at == level) {
      visit(child);
    } else {
      --at;
      group = child;
      open = open << 8 | overlap_mask(tree.group(at, group), box);
    }
  }
}

/// The same, of all that is below one box of the highest level.
template <class Visit>
MENISCUS_HD void for_each_overlap_below(const SurfaceTreeView& tree, uint32_t top_box, const Aabb& box,
                                        uint32_t level, uint32_t from, const Visit& visit) {
  const uint32_t top = tree.levels - 1;
  if (((top_box + 1) << 3 * (top - level)) <= from || !overlap(tree.box(top, top_box), box)) return;
  visit_overlaps(tree, top_box / 8, uint64_t{1} << top_box % 8, box, level, from, visit);
}

/// The same, of the whole tree.
template <class Visit>
MENISCUS_HD void for_each_overlap(const SurfaceTreeView& tree, const Aabb& box, uint32_t level, uint32_t from,
                                  const Visit& visit) {
  if (tree.levels == 0) return;
  const uint32_t top = tree.levels - 1;
  for (uint32_t root = 0; root < tree.groups_of(top); ++root)
    visit_overlaps(tree, root, overlap_mask(tree.group(top, root), box), box, level, from, visit);
}

}  // namespace meniscus::pbd
