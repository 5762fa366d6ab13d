// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Keeps spray, foam and bubbles out of solids.
#pragma once

#include "collision/contact/shape_contacts.h"
#include "fluid/diffuse/diffuse.h"

namespace meniscus {

/// Projects spray, foam and bubbles that are inside a solid to its surface, and removes their velocity into
/// it.
struct KeepOutOfSolids {
  collision::ShapeSet set;
  fluid::PendingDiffuse pending;
  float reach;  ///< m

  MENISCUS_HD void operator()(uint32_t i) const {
    if (i >= pending.count[0]) return;
    DiffuseParticle& p = pending.particles[i];
    for (uint32_t k = 0; k < set.shapes.count; ++k) {
      const collision::Shape& shape = set.shapes[k];
      const bool is_plane = shape.kind == collision::ShapeKind::plane;
      if (!collide(shape, CollisionFilter{})) continue;
      if (!is_plane && out_of_reach(shape, p.position, p.position, 0)) continue;
      const collision::SurfaceSample s = collision::sample_surface(set, shape, p.position, reach);
      if (s.distance >= 0) continue;
      if (is_plane && left_through_opening(set, shape, {p.position, p.position}, 0)) continue;
      p.position -= s.distance * s.normal;
      const float into = pbd::min(dot(p.velocity, s.normal), 0);
      p.velocity -= into * s.normal;
    }
  }
};

}  // namespace meniscus
