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

struct SurfaceView {
  View<const SurfaceTriangle> triangles;
  View<const Vec3> rest;  ///< m, of each vertex: the shape in which it is free of strain
  /// The corners of triangles at each vertex, 3 · triangle + corner: corners[corner_start[v]] to
  /// corners[corner_start[v + 1] − 1].
  View<const uint32_t> corner_start, corners;
};

}  // namespace meniscus::pbd
