// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Surfaces of triangles whose vertices are particles, for contacts of cloth.
#pragma once

#include <cstdint>

#include "pbd/device/base/view.h"
#include "pbd/math/vec.h"

namespace meniscus::pbd {

/// Vertex numbers: vertex v is the particle ParticleView::sorted + v.
struct SurfaceTriangle {
  uint32_t a, b, c;
  uint32_t piece;  ///< the piece of cloth that it belongs to
};

/// The surfaces of a batch's worlds (worlds.h), which are alike and follow one another: their triangles,
/// vertices and pieces have the numbers of the first world's, and so many more a world.
struct SurfaceWorlds {
  uint32_t worlds = 1;
  uint32_t vertices = 0, pieces = 0;  ///< of a world

  SurfaceTriangle of(uint32_t world, const SurfaceTriangle& t) const {
    const uint32_t v = world * vertices;
    return {t.a + v, t.b + v, t.c + v, t.piece + world * pieces};
  }
};

struct SurfaceView {
  View<const SurfaceTriangle> triangles;
  View<const Vec3> rest;  ///< m, of each vertex: the shape in which it is free of strain
  /// The corners of triangles at each vertex, 3 · triangle + corner: corners[corner_start[v]] to
  /// corners[corner_start[v + 1] − 1].
  View<const uint32_t> corner_start, corners;
};

}  // namespace meniscus::pbd
