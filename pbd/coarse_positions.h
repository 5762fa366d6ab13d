// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Positions in 16-bit floats, relative to grid cells, for the neighbour search on a GPU.
#pragma once

#include "pbd/device/cuda/half_blocks.h"
#include "pbd/grid.h"

namespace meniscus::pbd {

/// Positions of sorted particles within their cells, in six bytes instead of sixteen. Distances err by up to
/// three thousandths of the reach, which suffices to list neighbours. Kernels almost vanish there, and a pair
/// that is left out is left out of both lists. All lengths are in reaches.
struct CoarsePositions {
  View<HalfBlock> blocks;  ///< particles 4 k to 4 k + 3; empty where coarse positions are not used

  /// Along y and z the search knows which row of cells it scans. Along x a run has several cells, so
  /// positions repeat after this period, which is longer than a run.
  static constexpr float period = 4;

  /// In multiples of 1/1024, which a half represents exactly up to 2. So differences along y and z are exact.
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
