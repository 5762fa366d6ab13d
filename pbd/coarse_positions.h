// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "pbd/device/cuda/half_blocks.h"
#include "pbd/grid.h"

namespace meniscus::pbd {

/// Where sorted particles are in their cells, in six bytes for a position's sixteen: enough to tell who is in
/// reach, give or take three thousandths. Kernels are next to nothing there, and who is left out is left out
/// on both sides. All lengths are in reaches.
struct CoarsePositions {
  View<HalfBlock> blocks;  ///< particles 4 k to 4 k + 3; none where nobody will look

  /// Along y and z who looks knows which row of cells it looks through; along x, where a run has several
  /// cells, places come round after more than it is long.
  static constexpr float period = 4;

  /// In multiples of 1/1024, which a half holds up to 2: differences along y and z are exact.
  MENISCUS_HD static Vec3 in_cell(const GridView& grid, Vec3 p) {
    const Vec3 q = grid.inverse_reach * p;
    const auto fraction = [](float x) { return x - floorf(x); };
    const auto rounded = [](float x) { return (x + 12288.0f) - 12288.0f; };
    return {rounded(period * fraction(q.x / period) - period / 2), rounded(fraction(q.y) - 0.5f),
            rounded(fraction(q.z) - 0.5f)};
  }

  MENISCUS_HD void put(uint32_t i, const GridView& grid, Vec3 p) const {
    const Vec3 at = in_cell(grid, p);
    HalfBlock& block = blocks.data[i / HalfBlock::points];
    const uint32_t k = i % HalfBlock::points;
    block.x[k] = half_of(at.x);
    block.y[k] = half_of(at.y);
    block.z[k] = half_of(at.z);
  }
};

}  // namespace meniscus::pbd
