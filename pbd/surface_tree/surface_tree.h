// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "pbd/device/buffer.h"
#include "pbd/particles.h"
#include "pbd/surface_tree/boxes.h"

namespace meniscus::pbd {

/// Boxes around where vertices are, and where they come from, and `reach` (m) around that.
struct WayBoxes {
  View<const Vec4> previous, position;
  uint32_t first_vertex;
  float reach;

  WayBoxes(const ParticleView& particles, float reach_)
      : previous(particles.previous),
        position(particles.position),
        first_vertex(particles.sorted),
        reach(reach_) {}

  MENISCUS_HD static bool wanted() { return true; }
  MENISCUS_HD Aabb of(uint32_t v) const {
    const Vec3 from = load(previous, first_vertex + v).xyz(), to = load(position, first_vertex + v).xyz();
    return inflated({min(from, to), max(from, to)}, reach);
  }
};

/// Boxes around the triangles of a surface that moves, for queries in kernels (for_each_overlap). The order
/// of the triangles is found once; the boxes are fitted afresh whenever the vertices have moved.
template <class D>
class SurfaceTree {
 public:
  explicit SurfaceTree(D& device) : device_(device) {}

  /// The triangles from now on, in an order of the tree's own (see triangles()). `positions` (m, of each
  /// vertex) say which are neighbours: at rest, as cloth that is folded has others near it.
  void set_surface(std::span<const SurfaceTriangle> triangles, std::span<const Vec3> positions);

  /// Boxes around the triangles from those of their vertices, boxes.of(v). All stay as they are unless
  /// boxes.wanted(), which is asked on the device.
  template <class Boxes>
  void refit(const Boxes& boxes);

  SurfaceTreeView view();
  /// Places in the tree, those that nothing stands at included.
  uint32_t places() const { return static_cast<uint32_t>(order_.size()); }
  /// By place: the number of the triangle as it was given, or no_index.
  const std::vector<uint32_t>& order() const { return order_; }
  /// By place, on the host; a is no_index where nothing stands.
  const std::vector<SurfaceTriangle>& triangles() const { return sorted_; }

 private:
  D& device_;
  std::vector<uint32_t> order_;
  std::vector<SurfaceTriangle> sorted_;
  SurfaceTreeView layout_{};  // without its arrays
  Buffer<SurfaceTriangle> triangles_{device_, "surface triangles"};
  Buffer<BoxGroup> groups_{device_, "surface boxes"};
};

}  // namespace meniscus::pbd
