// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The triangles of a cube for each set of inside corners (Lorensen & Cline 1987), built by rules such that
// the surface is closed and manifold:
//   on a face with two inside corners that are diagonal, each is cut off separately, in both adjacent cubes;
//   no triangle has an edge across a face, where the adjacent cube might have the same.
// So each edge of the mesh, on a face or inside a cube, belongs to two triangles.
#pragma once

#include <cstdint>
#include <vector>

#include "pbd/device/base/qualifiers.h"

namespace meniscus::pbd {

/// Corner c is at x = c & 1, y = c >> 1 & 1, z = c >> 2. Edge e runs from its lower corner along an axis.
struct CubeEdge {
  uint32_t corner, axis;
};

MENISCUS_HD constexpr CubeEdge cube_edge(uint32_t e) {
  const uint32_t axis = e / 4, n = e % 4;  // n: the corner's place on the other two axes
  const uint32_t corner = axis == 0 ? n << 1 : axis == 1 ? (n & 1) | (n & 2) << 1 : n;
  return {corner, axis};
}

/// Sixteen bytes, so that one load reads them.
struct alignas(16) CubeTriangles {
  uint8_t edges[15];  ///< three for each triangle; corners are counter-clockwise as seen from outside
  uint8_t count;      ///< number of triangles, at most five
};

/// One element for each set of inside corners: bit c is set if corner c is inside.
std::vector<CubeTriangles> marching_cubes();

}  // namespace meniscus::pbd
