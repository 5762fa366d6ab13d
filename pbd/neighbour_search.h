// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The neighbour search: a counting sort of the particles by cell, and their neighbour lists.
#pragma once

#include <meniscus/types.h>

#include <utility>

#include "pbd/coarse_positions.h"
#include "pbd/grid.h"
#include "pbd/neighbours.h"
#include "pbd/particles.h"

namespace meniscus::pbd {

/// Points sorted by cell, and within each cell by number: the canonical order. It depends neither on the
/// previous order of the points nor on the table's shape. Within a cell, `placed` is in the order of arrival.
struct CellOrder {
  View<const uint32_t> key;      ///< by point: its cell
  View<const uint32_t> start;    ///< by cell
  View<const uint32_t> placed;   ///< by place: a point of the cell
  View<const uint32_t> numbers;  ///< by place: that point's number
  View<uint32_t> order;

  /// The point that belongs at place i; records it in `order`.
  MENISCUS_HD uint32_t find(uint32_t i) const {
    const uint32_t cell = load(key, load(placed, i)), begin = load(start, cell);
    return order[i] = load(placed, nth(begin, load(start, cell + 1), i - begin));
  }

 private:
  /// The place in [begin, end) whose number has n smaller ones.
  MENISCUS_HD uint32_t nth(uint32_t begin, uint32_t end, uint32_t n) const {
    constexpr uint32_t few = 16;
    if (end - begin > few) return nth_of_many(begin, end, n);
    uint32_t k = begin;
    while (below(load(numbers, k), begin, end) != n) ++k;
    return k;
  }
  /// By bisection of the number's value, because a quadratic search could take very long.
  MENISCUS_HD uint32_t nth_of_many(uint32_t begin, uint32_t end, uint32_t n) const {
    uint32_t number = 0;
    for (uint32_t bit = 1u << 31; bit > 0; bit /= 2) {
      if (below(number + bit, begin, end) <= n) number += bit;
    }
    uint32_t k = begin;
    while (load(numbers, k) != number) ++k;
    return k;
  }
  MENISCUS_HD uint32_t below(uint32_t number, uint32_t begin, uint32_t end) const {
    uint32_t count = 0;
    for (uint32_t k = begin; k < end; ++k) count += load(numbers, k) < number;
    return count;
  }
};

/// Layers of the part of a rank with its ghosts, on each axis.
struct PartLayers {
  int32_t y, z;
};

/// Sorts particles by cell and lists each one's neighbours within the support radius, once a substep. A GPU
/// uses coarse positions if there are many particles, unless sums are fixed.
template <class D>
class NeighbourSearch {
 public:
  /// `row_capacity`: entries of a list at first. A sort alone needs 4.
  NeighbourSearch(D& device, float support_radius, uint32_t row_capacity = usual_row);

  /// From the next reserve() on, there are so many worlds of `each` particles. Particles of a world follow
  /// one another, and stay so.
  void set_worlds(uint32_t worlds, uint32_t each) {
    worlds_ = worlds;
    grid_.each = each;
  }
  /// Allocates for `capacity` particles.
  void reserve(uint32_t capacity);

  /// The axis along which slabs would be cut: y or z.
  void set_layers(bool along_y) { grid_.layers_along_y = along_y; }
  /// From now on only this part has owned particles.
  void set_part(const Region& part);
  /// Like fit(), for a part: `count` and `extent` are of the particles of all ranks. So all ranks have the
  /// same cells along x, and along an axis without cuts.
  void fit_part(const Aabb& extent, uint32_t count, PartLayers layers);
  /// Whether the table of all layers has an entry of its own for each of so many, with one on either side.
  bool has_own_layers(uint32_t layers) const { return layers + 2 <= 1u << grid_.whole_layer_bits; }
  /// After a sort of a part: the numbers of owned particles and of ghosts.
  std::pair<uint32_t, uint32_t> count_part() const;

  /// From the next fit on, the table grows with the extent, up to 16 times, so that cells which are apart do
  /// not share entries. Its shape then depends on the extent and the number of particles alone.
  void set_own_cells(bool own) { has_own_cells_ = own; }

  /// Chooses the table's shape for this number of particles inside `extent`. Particles outside are found as
  /// well, but more slowly.
  void fit(const Aabb& extent, uint32_t count);

  /// The canonical order of the points, valid until the lists are built. points(i) is point i, a Vec4; each
  /// point has a unique number.
  template <class Points>
  CellOrder sort(const Points& points, View<const uint32_t> number);
  /// The point of each place, after CellOrder::find was called for it.
  View<const uint32_t> order() const { return order_.view(); }

  /// The reordering of the particles must fill these in, if there are any.
  CoarsePositions coarse() { return {is_coarse_ ? coarse_.view() : View<HalfBlock>{}}; }

  /// Lists the neighbours of particles that are already in order(). `longest` is one element, on the device.
  /// It is raised to the length of the longest list.
  void list(const ParticleView& particles, uint32_t sentinel, View<uint32_t> longest);
  uint32_t row_capacity() const { return row_capacity_; }
  /// Makes room for lists of this length; list() must run again.
  void grow_rows(uint32_t needed);

  NeighbourView view(uint32_t sentinel);
  const GridView& grid() const { return grid_; }

 private:
  /// At h = 2 s a list usually has about 32 entries, and rarely more than 44.
  static constexpr uint32_t usual_row = 48;

  void shape(const Aabb& extent, uint32_t count, uint32_t most_bits);
  void reserve_table(uint32_t cells);
  void grow_table(const Aabb& extent);
  uint32_t most_cells(uint32_t count) const;
  uint32_t least_cells() const { return worlds_ == 1 ? 4096 : 256; }  // of a world's table
  uint32_t stride() const { return D::interleaves_lists ? rows_ : 0; }
  void reserve_lists(uint32_t rows);

  D& device_;
  float support_radius_;
  GridView grid_;
  uint32_t capacity_ = 0, worlds_ = 1;
  uint32_t rows_ =
      0;  // lists that have room; in a part fewer than there may be particles, since ghosts have none
  uint32_t cells_ = 0;  // room for a table of so many, for each world
  uint32_t row_capacity_;
  bool is_coarse_ = false;  // lists are built from coarse positions
  bool has_own_cells_ = false;

  Buffer<uint32_t> order_{device_, "sorted order"};
  Buffer<uint32_t> cell_counts_{device_, "cell counts"};  // all 0 between sorts
  Buffer<uint32_t> cell_start_{device_, "cell starts"};
  Buffer<uint32_t> index_{device_,
                          "neighbour lists"};  // before there are lists, temporary memory of the sort
  Buffer<uint32_t> counts_{device_, "neighbour counts"};
  Buffer<HalfBlock> coarse_{device_, "coarse positions"};
};

}  // namespace meniscus::pbd
