// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A tree of bounding boxes over the triangles of a moving surface.
#pragma once

#include <span>
#include <vector>

#include "pbd/device/buffer.h"
#include "pbd/particles.h"
#include "pbd/surface_tree/boxes.h"

namespace meniscus::pbd {

/// Boxes around the present and previous positions of vertices, inflated by `reach` (m).
struct PathBoxes {
  View<const Vec4> previous, position;
  uint32_t first_vertex;
  float reach;

  PathBoxes(const ParticleView& particles, float reach_)
      : previous(particles.previous),
        position(particles.position),
        first_vertex(particles.sorted),
        reach(reach_) {}

  MENISCUS_HD static bool wanted(uint32_t /*world*/) { return true; }
  MENISCUS_HD Aabb of(uint32_t v) const {
    const Vec3 from = load(previous, first_vertex + v).xyz(), to = load(position, first_vertex + v).xyz();
    return inflated({min(from, to), max(from, to)}, reach);
  }
};

/// Boxes around the triangles of a moving surface, for queries in kernels (for_each_overlap). The order of
/// the triangles is found once; the boxes are refitted whenever the vertices have moved.
template <class D>
class SurfaceTree {
 public:
  explicit SurfaceTree(D& device) : device_(device) {}

  /// Sets the triangles, which the tree reorders (see triangles()). `positions` (m, of each vertex) determine
  /// which are neighbours. Use the rest positions: folded cloth has unrelated triangles nearby. With several
  /// worlds both are those of the first.
  void set_surface(std::span<const SurfaceTriangle> triangles, std::span<const Vec3> positions,
                   const SurfaceWorlds& worlds = {});

  /// Fits the triangles' boxes to those of their vertices, boxes.of(v). Those of a world do not change unless
  /// boxes.wanted(world), which the device evaluates.
  template <class Boxes>
  void refit(const Boxes& boxes) {
    refit(view(), boxes);
  }
  /// The same for the boxes at the start of a motion, after reserve_before().
  template <class Boxes>
  void refit_before(const Boxes& boxes) {
    refit(view().before(), boxes);
  }
  void reserve_before(bool any) { groups_before_.resize_discard(any ? groups_.size() : 0); }

  SurfaceTreeView view();
  /// The number of places in the tree of each world, including unused ones.
  uint32_t places() const { return static_cast<uint32_t>(order_.size()); }
  /// By place of the first world: the number of the triangle as given, or no_index.
  const std::vector<uint32_t>& order() const { return order_; }
  /// Likewise, on the host; a is no_index for unused places.
  const std::vector<SurfaceTriangle>& triangles() const { return sorted_; }

 private:
  template <class Boxes>
  void refit(const SurfaceTreeView& tree, const Boxes& boxes);

  D& device_;
  std::vector<uint32_t> order_;
  std::vector<SurfaceTriangle> sorted_;
  SurfaceTreeView layout_{};  // without its arrays
  Buffer<SurfaceTriangle> triangles_{device_, "surface triangles"};
  Buffer<BoxGroup> groups_{device_, "surface boxes"}, groups_before_{device_, "surface boxes"};
};

}  // namespace meniscus::pbd
