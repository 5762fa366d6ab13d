// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <meniscus/types.h>

#include "pbd/grid.h"
#include "pbd/neighbours.h"
#include "pbd/particles.h"

namespace meniscus::pbd {

/// Sorts particles by cell and lists each one's neighbours within the support radius, once a substep.
template <class D>
class NeighbourSearch {
 public:
  NeighbourSearch(D& device, float support_radius);

  /// Room for `capacity` particles.
  void reserve(uint32_t capacity);

  /// Chooses the table's shape for so many particles inside `extent`. Particles elsewhere are found as well,
  /// more slowly.
  void fit(const Aabb& extent, uint32_t count);

  /// The order of the points by grid cell: order()[i] is the present index of the one that belongs at i.
  /// Points in one cell keep their order. Point i is points(i), a Vec4.
  template <class Points>
  void sort(const Points& points, uint32_t count);
  View<const uint32_t> order() const { return order_.view(); }

  /// Lists the neighbours of particles that are in order() already. `longest` is one element, on the device:
  /// it becomes as long as the longest list needs to be, if it is less.
  void list(const ParticleView& particles, uint32_t sentinel, View<uint32_t> longest);
  uint32_t row_capacity() const { return row_capacity_; }
  /// Room for lists of this length; list() must run again.
  void grow_rows(uint32_t needed);

  NeighbourView view(uint32_t sentinel);
  const GridView& grid() const { return grid_; }

 private:
  uint32_t stride() const { return D::interleaves_lists ? capacity_ : 0; }

  D& device_;
  float support_radius_;
  GridView grid_;
  uint32_t capacity_ = 0;
  uint32_t row_capacity_ = 0;

  Buffer<uint32_t> order_{device_, "sorted order"};
  Buffer<uint32_t> cell_counts_{device_, "cell counts"};  // all 0 between sorts
  Buffer<uint32_t> cell_start_{device_, "cell starts"};
  Buffer<uint32_t> index_{device_, "neighbour lists"};  // before there are lists, what is needed to sort
  Buffer<uint32_t> counts_{device_, "neighbour counts"};
};

}  // namespace meniscus::pbd
