// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "pbd/device/buffer.h"
#include "pbd/particles.h"
#include "pbd/surface_boxes.h"

namespace meniscus::pbd {

/// Boxes around the triangles of a surface that moves, for queries in kernels (for_each_overlap). The order
/// of the triangles is found once; the boxes are fitted afresh whenever the vertices have moved.
template <class D>
class SurfaceTree {
 public:
  explicit SurfaceTree(D& device) : device_(device) {}

  /// The triangles from now on, in an order of the tree's own (see triangles()). `positions` (m, of each
  /// vertex) say which are neighbours: at rest, as cloth that is folded has others near it.
  void set_surface(std::span<const SurfaceTriangle> triangles, std::span<const Vec3> positions);

  /// Boxes around where the triangles are, and where they come from. reach(v, part, from, to) is how far
  /// (m) vertex v's box goes beyond its way, as it belongs to a triangle of that part.
  template <class Reach>
  void refit(const ParticleView& particles, const Reach& reach);

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
