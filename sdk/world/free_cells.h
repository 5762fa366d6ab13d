// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The part of a region that fluid may fill, as small cells in the region's own frame.
#pragma once

#include <meniscus/defs.h>

#include <cstdint>
#include <vector>

#include "pbd/math/vec.h"
#include "sdk/engine/engine.h"

namespace meniscus {

/// Cells of half a spacing, with a margin of `pad` cells around the region that are never free.
struct FreeCells {
  static constexpr int pad = 6;

  Vec3 lower;            ///< m, corner of the grid
  Vec3 size;             ///< m, of a cell
  int nx, ny, nz;        ///< cells
  float volume;          ///< m³, what a free cell stands for
  std::vector<char> is;  ///< by cell, whether it is free

  size_t at(int i, int j, int k) const {
    return static_cast<size_t>(i) +
           static_cast<size_t>(nx) *
               (static_cast<size_t>(j) + static_cast<size_t>(ny) * static_cast<size_t>(k));
  }
  Vec3 centre(int i, int j, int k) const {
    return lower + Vec3{size.x * (float(i) + 0.5f), size.y * (float(j) + 0.5f), size.z * (float(k) + 0.5f)};
  }
  bool is_free(Vec3 p) const;
};

/// The cells of a region in its own frame. None are free if no particle fits.
FreeCells cells_of(const Region& region, Engine& engine, float spacing, const FileReader& files);

}  // namespace meniscus
