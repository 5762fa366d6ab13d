// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A uniform grid without bounds: cell coordinates are any integers, and the table wraps around on each axis.
// Along y and z cells are as wide as the reach. Along x they are thinner, and adjacent in memory, so a
// particle scans little more of a row than its sphere covers. Two cells that share an entry are at least four
// reaches apart, so no pair is found twice. The distance test rejects particles that wrapped around.
//
// In a batch of worlds each world has a table of its own, one after the other.
#pragma once

#include "pbd/device/scalar.h"
#include "pbd/math/vec.h"
#include "pbd/ranks/region.h"

namespace meniscus::pbd {

struct CellCoordinates {
  int32_t x, y, z;
};

/// A range of sorted particles.
struct Run {
  uint32_t begin, end;
};

struct GridView {
  static constexpr uint32_t slices = 4;  ///< along x, in one reach
  static constexpr uint32_t least_bits_x = 4, least_bits = 2;

  float inverse_reach = 1;  ///< 1/m
  uint32_t bits_x = least_bits_x, bits_y = least_bits,
           bits_z = least_bits;  ///< the table is 2^bits cells wide
  uint32_t strip_bits =
      0;              ///< rows form strips of 2^strip_bits along y; the layers of a strip follow one another
  uint32_t each = 0;  ///< particles of a world, where there are several; 0: one world
  View<const uint32_t>
      start;  ///< of each cell's sorted particles, which end where those of the next cell start

  // The part of a rank has its cells first. Those of its ghosts follow: of the layers below and above it
  // along z, which have its corners, and then of those along y. Behind them is one cell for particles that
  // are neither. So owned particles come first, then ghosts. Without ranks all cells are in the part.
  bool is_part = false;
  Region part{};
  bool layers_along_y = false;  ///< of slabs, or else along z
  /// Of the table of all layers, of which that of a slab is a part. Without ranks it is the table itself.
  uint32_t whole_layer_bits = least_bits, whole_strip_bits = 0;

  MENISCUS_HD uint32_t key_bits() const { return bits_x + bits_y + bits_z; }
  /// Of a world, or of a part.
  MENISCUS_HD uint32_t cell_count() const { return 1u << key_bits(); }
  /// The first cell of particle i's world.
  MENISCUS_HD uint32_t first_cell(uint32_t i) const { return each ? i / each << key_bits() : 0; }
  /// With those of ghosts.
  MENISCUS_HD uint32_t all_cells() const {
    return is_part ? cell_count() + ghosts_along_z() + ghosts_along_y() + 1 : cell_count();
  }
  MENISCUS_HD int32_t layer(CellCoordinates c) const { return layers_along_y ? c.y : c.z; }
  /// Whether the part or a column next to it contains a cell.
  MENISCUS_HD bool holds(CellCoordinates c) const { return !is_part || part.is_near(c.y, c.z); }
  /// Whether the part contains a cell.
  MENISCUS_HD bool owns(CellCoordinates c) const { return part.contains(c.y, c.z); }

  MENISCUS_HD CellCoordinates coordinates(Vec3 p) const {
    // The clamp keeps the conversion defined for any float, NaN included.
    constexpr float limit = 1e9f;
    const auto cell = [&](float x) { return static_cast<int32_t>(floorf(clamp(x, -limit, limit))); };
    const Vec3 q = inverse_reach * p;
    return {cell(slices * q.x), cell(q.y), cell(q.z)};
  }

  MENISCUS_HD uint32_t key(CellCoordinates c) const {
    const uint32_t x = static_cast<uint32_t>(c.x) & ((1u << bits_x) - 1);
    return row(static_cast<uint32_t>(c.y), static_cast<uint32_t>(c.z)) + x;
  }
  /// The key of a row's first cell.
  MENISCUS_HD uint32_t row(uint32_t y, uint32_t z) const {
    if (!is_part) return own_row(y, z);
    // The layer below the part wraps around.
    const uint32_t from_y = y - static_cast<uint32_t>(part.first_y),
                   from_z = z - static_cast<uint32_t>(part.first_z);
    if (from_z >= part.layers_z()) return cell_count() + ghost_row(from_z != ~0u, y, bits_y);
    if (from_y >= part.layers_y())
      return cell_count() + ghosts_along_z() + ghost_row(from_y != ~0u, z, bits_z);
    return own_row(y, z);
  }

 private:
  MENISCUS_HD uint32_t own_row(uint32_t y, uint32_t z) const {
    const uint32_t strip = (y & ((1u << bits_y) - 1)) >> strip_bits, in_strip = y & ((1u << strip_bits) - 1);
    const uint32_t row_layer = (strip << bits_z) + (z & ((1u << bits_z) - 1));
    return ((row_layer << strip_bits) + in_strip) << bits_x;
  }
  /// The cells of two layers, below and above the part.
  MENISCUS_HD uint32_t ghosts_along_z() const { return part.is_cut_along_z() ? 2u << (bits_x + bits_y) : 0; }
  MENISCUS_HD uint32_t ghosts_along_y() const { return part.is_cut_along_y() ? 2u << (bits_x + bits_z) : 0; }
  /// In the cells of two layers: the row that is so far across.
  MENISCUS_HD uint32_t ghost_row(bool is_above, uint32_t across, uint32_t bits) const {
    return ((static_cast<uint32_t>(is_above) << bits) + (across & ((1u << bits) - 1))) << bits_x;
  }
};

/// The part of the grid's rows that is within reach of a point. All lengths are in reaches.
class Surroundings {
 public:
  /// `first_cell`: of the world.
  MENISCUS_HD Surroundings(const GridView& grid, Vec3 p, uint32_t first_cell = 0)
      : grid_(grid), first_cell_(first_cell) {
    const CellCoordinates cell = grid.coordinates(p);
    const Vec3 q = grid.inverse_reach * p;
    slack_ = slack_at(q);
    const auto fraction = [](float x, int32_t whole) {
      return clamp(x - static_cast<float>(whole), 0.0f, 1.0f);
    };
    x_ = fraction(GridView::slices * q.x, cell.x) + lift;
    first_ = static_cast<uint32_t>(cell.x) - static_cast<uint32_t>(lift);
    y_ = static_cast<uint32_t>(cell.y) - 1;
    z_ = static_cast<uint32_t>(cell.z) - 1;
    const float y = fraction(q.y, cell.y), z = fraction(q.z, cell.z);
    below_y2_ = away2(y);
    above_y2_ = away2(1 - y);
    below_z2_ = away2(z);
    above_z2_ = away2(1 - z);
    const Cells most = cut(0);
    wraps_ = most.first + most.count > width();
  }

  /// The rounding error of the coordinates of this point and of another. The fractions err by as much.
  MENISCUS_HD static float slack_at(Vec3 q) {
    return pbd::min(1e-4f + 2.5e-7f * (fabsf(q.x) + fabsf(q.y) + fabsf(q.z)), 2.0f);
  }

  static constexpr uint32_t rows = 9, most_runs = 2 * rows;

  /// The position of a row; 1: the row of the point.
  MENISCUS_HD static uint32_t row_y(uint32_t row) { return 0b10'00'10'00'01'01'10'00'01 >> 2 * row & 3; }
  MENISCUS_HD static uint32_t row_z(uint32_t row) { return 0b10'10'00'00'10'00'01'01'01 >> 2 * row & 3; }

  MENISCUS_HD uint32_t runs() const { return wraps_ ? most_runs : rows; }

  /// Where the table wraps around, a row's cells form two consecutive runs. So the order of the cells does
  /// not depend on the table's width.
  MENISCUS_HD Run run(uint32_t n) const { return wraps_ ? run(n / 2, n % 2 == 1) : run(n, false); }
  /// Rows with the most particles in reach come first. So adjacent threads, with a particle each, use the
  /// same row longest while they read their lists, and gather from the fewest cache lines.
  MENISCUS_HD Run run(uint32_t row, bool second) const {
    const uint32_t dy = row_y(row), dz = row_z(row);
    const float y2 = dy == 1 ? 0.0f : dy == 0 ? below_y2_ : above_y2_;
    const float z2 = dz == 1 ? 0.0f : dz == 0 ? below_z2_ : above_z2_;
    const Cells cells = cut(y2 + z2);
    const uint32_t end = cells.first + cells.count, wrapped = end > width() ? end - width() : 0;
    const uint32_t base = first_cell_ + grid_.row(y_ + dy, z_ + dz);
    return {load(grid_.start, base + (second ? 0 : cells.first)),
            load(grid_.start, base + (second ? wrapped : end - wrapped))};
  }

 private:
  static constexpr float lift = 64;  ///< makes cell numbers positive, so that conversion rounds down

  struct Cells {
    uint32_t first, count;
  };

  MENISCUS_HD uint32_t width() const { return 1u << grid_.bits_x; }
  /// A lower bound of a row's squared distance, if its edge is at this distance.
  MENISCUS_HD float away2(float edge) const {
    const float away = pbd::max(0.0f, edge - slack_);
    return away * away;
  }
  /// The cells of a row that are within reach, given the row's squared distance.
  MENISCUS_HD Cells cut(float distance2) const {
    const float half = GridView::slices * (quick_root(pbd::max(1 - distance2, 0.0f)) + slack_);
    const auto before = static_cast<uint32_t>(x_ - half), after = static_cast<uint32_t>(x_ + half);
    const uint32_t wanted = after - before + 1, count = wanted < width() ? wanted : width();
    return {(first_ + before) & (width() - 1), distance2 < 1 ? count : 0};
  }

  const GridView& grid_;
  uint32_t first_cell_;
  float slack_, x_, below_y2_, above_y2_, below_z2_, above_z2_;
  uint32_t first_, y_, z_;
  bool wraps_;  // the table wraps around within reach
};

/// The runs of sorted particles that together hold every particle within reach of a point.
class RunsAround {
 public:
  // All bounds are loaded at once. In a loop, a GPU's compiler would recompute their common terms for each.
  MENISCUS_HD RunsAround(const GridView& grid, Vec3 p, uint32_t first_cell = 0) {
    const Surroundings around(grid, p, first_cell);
    count_ = around.runs();
    if (count_ > Surroundings::rows) {
      for (uint32_t n = 0; n < Surroundings::most_runs; ++n) runs_[n] = around.run(n);
    } else {
      MENISCUS_UNROLL
      for (uint32_t row = 0; row < Surroundings::rows; ++row) runs_[row] = around.run(row, false);
    }
  }

  /// Whether all indices in the runs are within `most` of i.
  MENISCUS_HD bool are_within(uint32_t most, uint32_t i) const {
    bool within = true;
    const auto look = [&](Run run) {
      within = within && (run.begin >= run.end || (run.begin + most >= i && run.end <= i + most));
    };
    MENISCUS_UNROLL
    for (uint32_t row = 0; row < Surroundings::rows; ++row) look(runs_[row]);
    for (uint32_t n = Surroundings::rows; n < count_; ++n) look(runs_[n]);
    return within;
  }

  /// Calls visit(begin, end, y, z) for each run, where y and z are the offset of its row from the point's
  /// row, in reaches.
  template <class Visit>
  MENISCUS_HD void for_each_row(const Visit& visit) const {
    for (uint32_t n = 0; n < count_; ++n) {
      const uint32_t row = count_ > Surroundings::rows ? n / 2 : n;
      visit(runs_[n].begin, runs_[n].end, static_cast<float>(Surroundings::row_y(row)) - 1,
            static_cast<float>(Surroundings::row_z(row)) - 1);
    }
  }

  /// Calls visit(begin, end) for each run.
  template <class Visit>
  MENISCUS_HD void for_each(const Visit& visit) const {
    for (uint32_t n = 0; n < count_; ++n) visit(runs_[n].begin, runs_[n].end);
  }

 private:
  Run runs_[Surroundings::most_runs];
  uint32_t count_;
};

}  // namespace meniscus::pbd
