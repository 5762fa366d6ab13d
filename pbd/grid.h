// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A uniform grid without bounds: cell coordinates are any integers, and the table wraps around on each axis.
// Cells are as wide as the reach along y and z, and sliced along x, in which they lie side by side in memory:
// from each row of cells a particle looks at no more than its sphere cuts out. Two cells that share an entry
// lie at least four reaches apart, so that no pair is seen twice; the distance test drops what the wrap
// brought in.
#pragma once

#include "pbd/device/scalar.h"
#include "pbd/math/vec.h"

namespace meniscus::pbd {

struct CellCoordinates {
  int32_t x, y, z;
};

/// Of sorted particles.
struct Run {
  uint32_t begin, end;
};

struct GridView {
  static constexpr uint32_t slices = 4;  ///< along x, a reach
  static constexpr uint32_t least_bits_x = 4, least_bits = 2;

  float inverse_reach = 1;  ///< 1/m
  uint32_t bits_x = least_bits_x, bits_y = least_bits,
           bits_z = least_bits;  ///< the table is 2^bits cells wide
  View<const uint32_t> start;    ///< of each cell's sorted particles, which end where the next one's start

  MENISCUS_HD uint32_t key_bits() const { return bits_x + bits_y + bits_z; }
  MENISCUS_HD uint32_t cell_count() const { return 1u << key_bits(); }

  MENISCUS_HD CellCoordinates coordinates(Vec3 p) const {
    // The clamp keeps the conversion defined for any float, NaN included.
    constexpr float limit = 1e9f;
    const auto cell = [&](float x) { return static_cast<int32_t>(floorf(clamp(x, -limit, limit))); };
    const Vec3 q = inverse_reach * p;
    return {cell(slices * q.x), cell(q.y), cell(q.z)};
  }

  MENISCUS_HD uint32_t key(CellCoordinates c) const {
    const auto wrap = [](int32_t v, uint32_t bits) { return static_cast<uint32_t>(v) & ((1u << bits) - 1); };
    return wrap(c.x, bits_x) | wrap(c.y, bits_y) << bits_x | wrap(c.z, bits_z) << (bits_x + bits_y);
  }
};

/// What of the grid's rows is within reach of a point. All lengths are in reaches.
class Surroundings {
 public:
  MENISCUS_HD Surroundings(const GridView& grid, Vec3 p) : grid_(grid), cell_(grid.coordinates(p)) {
    const Vec3 q = grid.inverse_reach * p;
    // Of what the coordinates have been rounded by, this point's and another's; the fractions are then as far
    // off.
    slack_ = pbd::min(1e-4f + 2.5e-7f * (fabsf(q.x) + fabsf(q.y) + fabsf(q.z)), 2.0f);
    x_ = clamp(GridView::slices * q.x - static_cast<float>(cell_.x), 0.0f, 1.0f);
    y_ = clamp(q.y - static_cast<float>(cell_.y), 0.0f, 1.0f);
    z_ = clamp(q.z - static_cast<float>(cell_.z), 0.0f, 1.0f);
    const Cells most = cut(0);
    wraps_ = most.first + most.count > width() ? 1 : 0;
  }

  MENISCUS_HD uint32_t runs() const { return 9u << wraps_; }

  /// Where the table wraps around, a row's cells are two runs.
  MENISCUS_HD Run run(uint32_t n) const {
    const auto row = static_cast<int32_t>(n >> wraps_);
    const int32_t dy = row % 3 - 1, dz = row / 3 - 1;
    const float y = away(dy, y_), z = away(dz, z_);
    const Cells cells = cut(y * y + z * z);
    const uint32_t end = cells.first + cells.count, wrapped = end > width() ? end - width() : 0;
    const uint32_t base = grid_.key({0, cell_.y + dy, cell_.z + dz});
    const bool second = (n & wraps_) != 0;
    return {load(grid_.start, base + (second ? 0 : cells.first)),
            load(grid_.start, base + (second ? wrapped : end - wrapped))};
  }

 private:
  struct Cells {
    uint32_t first, count;
  };

  MENISCUS_HD uint32_t width() const { return 1u << grid_.bits_x; }
  /// At least how far the rows are that lie `d` rows away from a point at the fraction x of its own.
  MENISCUS_HD float away(int32_t d, float x) const {
    return d == 0 ? 0.0f : pbd::max(0.0f, (d < 0 ? x : 1 - x) - slack_);
  }
  /// The cells of a row that are within reach, where the row's distance squared is known.
  MENISCUS_HD Cells cut(float distance2) const {
    if (distance2 >= 1) return {0, 0};
    const float half = GridView::slices * (sqrtf(1 - distance2) + slack_);
    // Rounds down, as what is converted is positive.
    const auto whole = [](float x) { return static_cast<int32_t>(x + 64) - 64; };
    const int32_t before = whole(x_ - half), after = whole(x_ + half);
    const uint32_t count = static_cast<uint32_t>(after - before + 1);
    return {static_cast<uint32_t>(cell_.x + before) & (width() - 1), count < width() ? count : width()};
  }

  const GridView& grid_;
  CellCoordinates cell_;
  float slack_, x_, y_, z_;
  uint32_t wraps_;  // 1 where the table wraps around within reach
};

/// Calls visit(begin, end) for runs of sorted particles that together hold every particle within reach of p.
template <class Visit>
MENISCUS_HD void for_each_run(const GridView& grid, Vec3 p, const Visit& visit) {
  const Surroundings around(grid, p);
  const uint32_t runs = around.runs();
  Run next = around.run(0);  // the next run's bounds are on their way while this one is visited
  MENISCUS_NO_UNROLL
  for (uint32_t n = 0; n < runs; ++n) {
    const Run present = next;
    if (n + 1 < runs) next = around.run(n + 1);
    visit(present.begin, present.end);
  }
}

}  // namespace meniscus::pbd
