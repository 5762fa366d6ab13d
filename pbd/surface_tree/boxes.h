// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The tree of boxes over a surface's triangles as kernels see it. It has no pointers. Triangles are ordered
// so that those near in the material are near in the array. Box b of level 0 is that of triangle b, and box b
// of a higher level contains the boxes 8b to 8b + 7 of the level below.
#pragma once

#include <cmath>
#include <cstdint>

#include "pbd/contacts.h"
#include "pbd/device/base/eight.h"
#include "pbd/device/scalar.h"
#include "pbd/device/teams.h"
#include "pbd/surface_tree/surface.h"

namespace meniscus::pbd {

/// The neutral element of joined().
inline constexpr Aabb empty_box{{most_finite, most_finite, most_finite},
                                {-most_finite, -most_finite, -most_finite}};
/// The box of an unused place. Its coordinates are NaN, so no box overlaps it, not even an infinite one.
MENISCUS_HD constexpr Aabb nowhere() {
  return {{NAN, NAN, NAN}, {NAN, NAN, NAN}};
}

/// The union of two boxes; the second if the first is nowhere().
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

/// Eight boxes side by side, so that one operation tests all.
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
  const float least[3] = {box.lower.x, box.lower.y, box.lower.z};
  const float most[3] = {box.upper.x, box.upper.y, box.upper.z};
  return overlap_mask(group.lower, group.upper, least, most);
}

/// Two boxes of the same thing, at the start and at the end of a steady motion.
struct MovingBox {
  Aabb before, after;
};

/// Bit k is set unless box k is on one side of the other along an axis both at the start and at the end. It
/// is so in between as well, since limits move steadily. A motion that all share changes nothing.
MENISCUS_HD inline uint32_t overlap_mask(const BoxGroup& before, const BoxGroup& after,
                                         const MovingBox& box) {
  const float least[2][3] = {{box.before.lower.x, box.before.lower.y, box.before.lower.z},
                             {box.after.lower.x, box.after.lower.y, box.after.lower.z}};
  const float most[2][3] = {{box.before.upper.x, box.before.upper.y, box.before.upper.z},
                            {box.after.upper.x, box.after.upper.y, box.after.upper.z}};
  uint32_t mask = 0xff;
  for (uint32_t axis = 0; axis < 3; ++axis) {
    for (uint32_t k = 0; k < BoxGroup::size; ++k) {
      const bool begins = before.lower[axis][k] <= most[0][axis] || after.lower[axis][k] <= most[1][axis];
      const bool ends = before.upper[axis][k] >= least[0][axis] || after.upper[axis][k] >= least[1][axis];
      if (!begins || !ends) mask &= ~(1u << k);
    }
  }
  return mask;
}

/// Eight threads test a group, and a whole warp works on one query: there are few queries, with many
/// triangles each.
using GroupTeam = Team<BoxGroup::size>;
using SearchTeam = Team<32>;

struct SurfaceTreeView {
  static constexpr uint32_t most_levels = 8;  // so that the open boxes of a descent fit into 64 bits

  View<BoxGroup> groups;         ///< of all levels
  View<BoxGroup> groups_before;  ///< the same at the start of a motion; or empty
  uint32_t start[most_levels];   ///< of each level, its first group
  uint32_t boxes[most_levels];   ///< of each level; its last group is padded with nowhere()
  uint32_t levels = 0;
  uint32_t worlds = 1;                    ///< each has as many boxes of each level, which follow one another
  View<const SurfaceTriangle> triangles;  ///< in the tree's order; a is no_index for padding

  MENISCUS_HD BoxGroup& group(uint32_t level, uint32_t g) const { return groups[start[level] + g]; }
  MENISCUS_HD Aabb box(uint32_t level, uint32_t b) const { return group(level, b / 8).box(b % 8); }
  MENISCUS_HD BoxGroup& group_before(uint32_t level, uint32_t g) const {
    return groups_before[start[level] + g];
  }
  MENISCUS_HD MovingBox moving_box(uint32_t level, uint32_t b) const {
    return {group_before(level, b / 8).box(b % 8), box(level, b)};
  }
  /// The view of the boxes at the start of the motion.
  SurfaceTreeView before() const {
    SurfaceTreeView tree = *this;
    tree.groups = groups_before;
    return tree;
  }
  MENISCUS_HD uint32_t groups_of(uint32_t level) const { return (boxes[level] + 7) / 8; }
  /// Of a level, in one world.
  MENISCUS_HD uint32_t groups_of_world(uint32_t level) const { return groups_of(level) / worlds; }
};

/// Which threads test the eight boxes of a group: one thread all of them, or the threads of a warp that walk
/// together one each.
struct TestAlone {
  MENISCUS_HD static uint32_t overlaps(const BoxGroup& group, const Aabb& box) {
    return overlap_mask(group, box);
  }
};
struct TestTogether {
  MENISCUS_HD static uint32_t overlaps(const BoxGroup& group, const Aabb& box) {
    if (GroupTeam::count() == 1) return overlap_mask(group, box);
    const uint32_t k = SearchTeam::rank() % BoxGroup::size;
    return SearchTeam::ballot(overlap(group.box(k), box)) & 0xff;
  }
};

/// Iterates over the boxes b ≥ `from` of a level that overlap, in ascending order; level 0 has the triangles'
/// boxes. It finds those of one world. It stops at each group with overlaps, so that the threads of a warp
/// continue together.
template <class Test = TestAlone>
class OverlapWalk {
 public:
  MENISCUS_HD OverlapWalk(const SurfaceTreeView& tree, uint32_t world, const Aabb& box, uint32_t level,
                          uint32_t from = 0)
      : tree_(tree), box_(box), level_(level), from_(from), at_(tree.levels - 1) {
    const uint32_t each = tree.levels ? tree.groups_of_world(at_) : 0;
    next_root_ = world * each;
    roots_ = next_root_ + each;
  }

  /// The next box; false where there are no more.
  MENISCUS_HD bool next(uint32_t& box) {
    while (advance()) {
      box = 8 * group_ + lowest_bit(here());
      open_ &= open_ - 1;
      if (box >= from_) return true;
    }
    return false;
  }
  /// The next group, and a mask of its boxes that overlap.
  MENISCUS_HD bool next_group(uint32_t& group, uint32_t& boxes) {
    if (!advance()) return false;
    group = group_;
    boxes = here();
    open_ &= ~uint64_t{0xff};
    return true;
  }

 private:
  MENISCUS_HD uint32_t here() const { return static_cast<uint32_t>(open_ & 0xff); }

  /// Advances to open boxes of the level.
  MENISCUS_HD bool advance() {
    const uint32_t top = tree_.levels - 1;
    for (;;) {
      if (here() == 0) {
        if (at_ == top) {
          if (next_root_ >= roots_) return false;
          group_ = next_root_++;
          open_ = Test::overlaps(tree_.group(top, group_), box_);
        } else {
          open_ >>= 8;
          group_ >>= 3;
          ++at_;
        }
      } else if (at_ == level_) {
        return true;
      } else {
        const uint32_t child = 8 * group_ + lowest_bit(here());
        open_ &= open_ - 1;
        if (((child + 1) << 3 * (at_ - level_)) <= from_) continue;
        --at_;
        group_ = child;
        open_ = open_ << 8 | Test::overlaps(tree_.group(at_, child), box_);
      }
    }
  }

  const SurfaceTreeView& tree_;
  const Aabb box_;
  const uint32_t level_, from_;
  uint64_t open_ = 0;  // eight bits for each level, the lowest for group_: boxes still to be visited
  uint32_t at_, group_ = 0;
  uint32_t roots_, next_root_;
};

/// Calls visit(b) for each box b ≥ `from` of a level that overlaps, in ascending order.
template <class Visit>
MENISCUS_HD void for_each_overlap(const SurfaceTreeView& tree, uint32_t world, const Aabb& box,
                                  uint32_t level, uint32_t from, const Visit& visit) {
  OverlapWalk walk(tree, world, box, level, from);
  for (uint32_t b; walk.next(b);) visit(b);
}

/// m², the squared distance from a point to a box.
MENISCUS_HD inline float distance2(const Aabb& box, Vec3 p) {
  const Vec3 d = max(max(box.lower - p, p - box.upper), {0, 0, 0});
  return dot(d, d);
}

/// Whether any box of a level overlaps.
MENISCUS_HD inline bool overlaps_any(const SurfaceTreeView& tree, uint32_t world, const Aabb& box,
                                     uint32_t level) {
  OverlapWalk walk(tree, world, box, level);
  uint32_t found;
  return walk.next(found);
}

/// The subset of eight boxes for which so(k) holds, by a warp.
template <class So>
MENISCUS_HD uint32_t boxes_where(uint32_t boxes, const So& so) {
  if (SearchTeam::count() > 1) {
    const uint32_t k = SearchTeam::rank() % BoxGroup::size;
    return SearchTeam::ballot((boxes >> k & 1) && so(k)) & 0xff;
  }
  uint32_t left = 0;
  for (; boxes; boxes &= boxes - 1)
    if (so(lowest_bit(boxes))) left |= boxes & -boxes;
  return left;
}

/// The boxes without the first `n`.
MENISCUS_HD inline uint32_t boxes_behind(uint32_t boxes, uint32_t n) {
  for (; n > 0; --n) boxes &= boxes - 1;
  return boxes;
}

/// Calls visit(place, overlaps) for the triangles near a box, in groups of eight for which wanted(group)
/// holds. A GPU's warp distributes them, a group to eight threads. All threads call visit together, including
/// those whose triangle does not overlap. A single thread visits only triangles that overlap.
template <class Wanted, class Visit>
MENISCUS_HD void for_each_place_in_warp(const SurfaceTreeView& tree, uint32_t world, const Aabb& box,
                                        const Wanted& wanted, const Visit& visit) {
  constexpr uint32_t teams = SearchTeam::count() / GroupTeam::count();
  OverlapWalk<TestTogether> walk(tree, world, box, 1);
  for (uint32_t above, boxes; walk.next_group(above, boxes);) {
    boxes = boxes_where(boxes, [&](uint32_t k) { return wanted(8 * above + k); });
    uint32_t self = boxes_behind(boxes, SearchTeam::rank() / BoxGroup::size);
    for (; boxes; boxes = boxes_behind(boxes, teams), self = boxes_behind(self, teams)) {
      const uint32_t group = 8 * above + (self ? lowest_bit(self) : 0);
      if constexpr (GroupTeam::count() == 1) {
        for (uint32_t left = overlap_mask(tree.group(0, group), box); left; left &= left - 1)
          visit(8 * group + lowest_bit(left), true);
      } else {
        const uint32_t place = 8 * group + GroupTeam::rank();
        visit(place, self != 0 && overlap(tree.box(0, place), box));
      }
    }
  }
}

/// Calls visit(b) for each triangle's box that overlaps, distributed as in for_each_place_in_warp.
template <class Wanted, class Visit>
MENISCUS_HD void for_each_overlap_in_warp(const SurfaceTreeView& tree, uint32_t world, const Aabb& box,
                                          const Wanted& wanted, const Visit& visit) {
  for_each_place_in_warp(tree, world, box, wanted, [&](uint32_t place, bool overlaps) {
    if (overlaps) visit(place);
  });
}

/// Accepts the groups that overlap a ball.
struct GroupsInBall {
  const SurfaceTreeView& tree;
  Vec3 centre;
  float radius;

  MENISCUS_HD bool operator()(uint32_t group) const {
    return distance2(tree.box(1, group), centre) < radius * radius;
  }
};

}  // namespace meniscus::pbd
