// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A uniform grid without bounds: cell coordinates are any integers, and the table wraps around on each axis.
// Two cells that share an entry lie at least four cells apart, so the 27 cells around a particle never meet
// in one entry: no pair is seen twice, and the distance test drops what the wrap brought in.
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
  float inverse_cell = 1;  ///< 1/m
  uint32_t bits_x = 2, bits_y = 2,
           bits_z = 2;         ///< the table is 2^bits cells wide on each axis, at least four
  View<const uint32_t> start;  ///< of each cell's sorted particles, which end where the next one's start

  MENISCUS_HD uint32_t key_bits() const { return bits_x + bits_y + bits_z; }
  MENISCUS_HD uint32_t cell_count() const { return 1u << key_bits(); }

  MENISCUS_HD CellCoordinates coordinates(Vec3 p) const {
    // The clamp keeps the conversion defined for any float, NaN included.
    constexpr float limit = 1e9f;
    const auto cell = [&](float x) {
      return static_cast<int32_t>(floorf(clamp(x * inverse_cell, -limit, limit)));
    };
    return {cell(p.x), cell(p.y), cell(p.z)};
  }

  MENISCUS_HD uint32_t key(CellCoordinates c) const {
    const auto wrap = [](int32_t v, uint32_t bits) { return static_cast<uint32_t>(v) & ((1u << bits) - 1); };
    return wrap(c.x, bits_x) | wrap(c.y, bits_y) << bits_x | wrap(c.z, bits_z) << (bits_x + bits_y);
  }
};

/// Calls visit(begin, end) for runs of sorted particles that together hold every particle of the 27 cells
/// around c. Three cells in a row are one run, but where the table wraps around.
template <class Visit>
MENISCUS_HD void for_each_run(const GridView& grid, CellCoordinates c, const Visit& visit) {
  const uint32_t last = (1u << grid.bits_x) - 1;
  const uint32_t x = static_cast<uint32_t>(c.x) & last;
  const bool wraps = x == 0 || x == last;
  const auto run = [&](int32_t n) {
    const int32_t row = wraps ? n / 3 : n;
    const uint32_t middle = grid.key({c.x, c.y + row % 3 - 1, c.z + row / 3 - 1});
    const uint32_t cell = middle - x + ((x + static_cast<uint32_t>(wraps ? n % 3 : 0) + last) & last);
    return Run{load(grid.start, cell), load(grid.start, wraps ? cell + 1 : cell + 3)};
  };
  const int32_t runs = wraps ? 27 : 9;
  Run next = run(0);  // the next run's bounds are on their way while this one is visited
  MENISCUS_NO_UNROLL
  for (int32_t n = 0; n < runs; ++n) {
    const Run present = next;
    if (n + 1 < runs) next = run(n + 1);
    visit(present.begin, present.end);
  }
}

}  // namespace meniscus::pbd
