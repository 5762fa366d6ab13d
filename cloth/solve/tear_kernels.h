// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernel that finds edges stretched beyond their limit.
#pragma once

#include "cloth/solve/vertex_state.h"
#include "pbd/device/base/atomics.h"
#include "pbd/surface_tree/surface.h"

namespace meniscus::cloth::tear_kernels {

/// Records whether any edge is stretched beyond the tear strain of its piece.
struct FindTears {
  pbd::SurfaceView surface;
  VertexState vertices;
  View<uint32_t> found;

  MENISCUS_HD void operator()(uint32_t k) const {
    const pbd::SurfaceTriangle t = surface.triangles[k];
    const float limit = vertices.pieces[t.piece].tear_strain;
    if (limit == 0) return;
    const bool tears = beyond(t.a, t.b, limit) || beyond(t.b, t.c, limit) || beyond(t.c, t.a, limit);
    if (tears) pbd::atomic_max(found[0], 1);
  }

  MENISCUS_HD bool beyond(uint32_t a, uint32_t b, float limit) const {
    const Vec3 now = vertices.position(b).xyz() - vertices.position(a).xyz(),
               rest = surface.rest[b] - surface.rest[a];
    return dot(now, now) > (1 + limit) * (1 + limit) * dot(rest, rest);
  }
};

}  // namespace meniscus::cloth::tear_kernels
