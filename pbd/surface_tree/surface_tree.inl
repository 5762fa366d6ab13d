// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Builds the levels of the tree, and refits its boxes.
#pragma once

#include <algorithm>

#include "pbd/surface_tree/order.h"
#include "pbd/surface_tree/surface_tree.h"

namespace meniscus::pbd {

namespace surface_kernels {

/// Fits a level's boxes to those of the level below.
template <class Boxes>
struct FitLevel {
  SurfaceTreeView tree;
  Boxes boxes;
  uint32_t level;

  MENISCUS_HD void operator()(uint32_t b) const {
    if (!boxes.wanted(b / (8 * tree.groups_of_world(level)))) return;
    Aabb box = empty_box;
    if (b < tree.boxes[level]) {
      const BoxGroup& below = tree.group(level - 1, b);
      for (uint32_t k = 0; k < BoxGroup::size; ++k) box = joined(below.box(k), box);
    }
    tree.group(level, b / 8).set(b % 8, box.lower.x <= box.upper.x ? box : nowhere());
  }
};

/// Fits the boxes of triangles, and those above them up to level `top`. Each group of threads takes one box
/// of that level with all boxes below it.
template <class Boxes>
struct FitSubtrees {
  struct Scratch {};

  SurfaceTreeView tree;
  Boxes boxes;
  uint32_t top;

  template <class Group>
  MENISCUS_HD void operator()(const Group& group, Scratch& /*scratch*/, uint32_t n) const {
    if (!boxes.wanted(n / (8 * tree.groups_of_world(top)))) return;
    for (uint32_t level = 0; level <= top; ++level) {
      const uint32_t count = 1u << 3 * (top - level), first = n * count, end = 8 * tree.groups_of(level);
      group.for_each(count, [&](uint32_t k) {
        if (first + k >= end) return;
        if (level == 0)
          fit_triangle(first + k);
        else
          FitLevel<Boxes>{tree, boxes, level}(first + k);
      });
    }
  }

  MENISCUS_HD void fit_triangle(uint32_t place) const {
    const SurfaceTriangle t = load(tree.triangles, place);
    Aabb box = nowhere();
    if (t.a != no_index) box = joined(joined(boxes.of(t.a), boxes.of(t.b)), boxes.of(t.c));
    tree.group(0, place / 8).set(place % 8, box);
  }
};

}  // namespace surface_kernels

template <class D>
void SurfaceTree<D>::set_surface(std::span<const SurfaceTriangle> triangles, std::span<const Vec3> positions,
                                 const SurfaceWorlds& worlds) {
  constexpr uint32_t most_roots = 64;  // this many boxes or fewer are tested one by one
  order_ = tree_order(triangles, positions);
  uint32_t levels = 0;
  for (uint32_t boxes = places(); boxes > 0; boxes = (boxes + 7) / 8) {
    const bool enough = ++levels > 1 && boxes <= most_roots;
    if (enough || levels == SurfaceTreeView::most_levels) break;
  }
  // The boxes of a world fill whole groups on each level, so that no box has triangles of two worlds.
  while (worlds.worlds > 1 && order_.size() % (size_t{1} << 3 * levels) != 0) order_.push_back(no_index);

  layout_ = {};
  layout_.worlds = worlds.worlds;
  uint32_t groups = 0;
  for (uint32_t boxes = worlds.worlds * places(); layout_.levels < levels; boxes = (boxes + 7) / 8) {
    layout_.start[layout_.levels] = groups;
    layout_.boxes[layout_.levels] = boxes;
    groups += layout_.groups_of(layout_.levels++);
  }
  constexpr SurfaceTriangle unused{no_index, no_index, no_index, 0};
  sorted_.clear();
  for (uint32_t t : order_) sorted_.push_back(t == no_index ? unused : triangles[t]);
  std::vector<SurfaceTriangle> all;
  all.reserve(worlds.worlds * sorted_.size());
  for (uint32_t w = 0; w < worlds.worlds; ++w) {
    for (const SurfaceTriangle& t : sorted_) all.push_back(t.a == no_index ? unused : worlds.of(w, t));
  }
  triangles_.resize_discard(all.size());
  triangles_.write(all);
  groups_.resize_discard(groups);
}

template <class D>
template <class Boxes>
void SurfaceTree<D>::refit(const SurfaceTreeView& tree, const Boxes& boxes) {
  using namespace surface_kernels;
  if (tree.levels == 0) return;
  const uint32_t top = std::min(3u, tree.levels - 1);
  device_.parallel_for_groups("surface/subtrees", 8 * tree.groups_of(top),
                              FitSubtrees<Boxes>{tree, boxes, top});
  for (uint32_t level = top + 1; level < tree.levels; ++level)
    device_.parallel_for("surface/boxes", 8 * tree.groups_of(level), FitLevel<Boxes>{tree, boxes, level});
}

template <class D>
SurfaceTreeView SurfaceTree<D>::view() {
  SurfaceTreeView tree = layout_;
  tree.groups = groups_.view();
  tree.groups_before = groups_before_.view();
  tree.triangles = triangles_.view();
  return tree;
}

}  // namespace meniscus::pbd
