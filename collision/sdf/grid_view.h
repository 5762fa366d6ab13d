// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Scalar fields on a lattice, as kernels read them, with trilinear interpolation.
#pragma once

#include "collision/mesh/lattice.h"
#include "pbd/device/base/view.h"

namespace meniscus::collision {

/// A scalar field on the points of a lattice with at least two points along each axis. Trilinear between
/// them.
struct GridView {
  Lattice nodes;
  pbd::View<const float> values;
};

struct GridSample {
  float value;
  Vec3 gradient;  ///< 1/m
};

/// NaN gives the lower limit, so that an index computed from it is in range.
MENISCUS_HD inline float clamped(float a, float lower, float upper) {
  return a > lower ? (a < upper ? a : upper) : lower;
}

/// The point of the grid's box that is nearest to p.
MENISCUS_HD inline Vec3 clamp_to_grid(const GridView& grid, Vec3 p) {
  const Lattice& n = grid.nodes;
  const Vec3 upper = n.point(n.nx - 1, n.ny - 1, n.nz - 1);
  return {clamped(p.x, n.origin.x, upper.x), clamped(p.y, n.origin.y, upper.y),
          clamped(p.z, n.origin.z, upper.z)};
}

// A cell, and the position inside it.
struct GridPlace {
  uint32_t cell;
  float fraction;
};

MENISCUS_HD inline GridPlace place_in_grid(float u, uint32_t nodes) {
  const float inside = clamped(u, 0, static_cast<float>(nodes - 1));
  uint32_t cell = static_cast<uint32_t>(inside);
  if (cell > nodes - 2) cell = nodes - 2;
  return {cell, inside - static_cast<float>(cell)};
}

/// The trilinear field and its gradient at p, which is in the grid's box.
MENISCUS_HD inline GridSample sample_grid(const GridView& grid, Vec3 p) {
  const Lattice& n = grid.nodes;
  const Vec3 u = (p - n.origin) / n.spacing;
  const GridPlace x = place_in_grid(u.x, n.nx), y = place_in_grid(u.y, n.ny), z = place_in_grid(u.z, n.nz);

  // Along x first: value and slope on four edges of the cell, then along the other axes.
  float value[4], slope[4];
  for (uint32_t edge = 0; edge < 4; ++edge) {
    const uint32_t at = n.index(x.cell, y.cell + (edge & 1), z.cell + (edge >> 1));
    slope[edge] = grid.values[at + 1] - grid.values[at];
    value[edge] = grid.values[at] + x.fraction * slope[edge];
  }
  const float y0 = value[0] + y.fraction * (value[1] - value[0]);
  const float y1 = value[2] + y.fraction * (value[3] - value[2]);
  const float slope_x0 = slope[0] + y.fraction * (slope[1] - slope[0]);
  const float slope_x1 = slope[2] + y.fraction * (slope[3] - slope[2]);
  const float slope_y0 = value[1] - value[0], slope_y1 = value[3] - value[2];
  const Vec3 gradient{slope_x0 + z.fraction * (slope_x1 - slope_x0),
                      slope_y0 + z.fraction * (slope_y1 - slope_y0), y1 - y0};
  return {y0 + z.fraction * (y1 - y0), gradient / n.spacing};
}

}  // namespace meniscus::collision
