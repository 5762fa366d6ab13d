// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Removes seed points that are too near to cloth, or inside of a closed driven surface.
#include "collision/mesh/triangle_bvh_query.h"
#include "pbd/filter.h"
#include "sdk/engine/tuning.h"
#include "sdk/world/world_impl.h"

namespace meniscus {

void World::Impl::keep_off_cloth(std::vector<Vec3>& points, const CollisionFilter& filter) {
  // As beside solids, the margin keeps rounding from removing a layer that just fits.
  const float clearance = engine_tuning::clearance * def.particle_spacing;
  fetch_cloth();
  cloths.for_each([&](uint32_t, const ClothEntry& entry) {
    if (points.empty() || !pbd::meet(entry.def.filter, filter)) return;
    const collision::TriangleBvh tree({entry.range.state.positions, entry.mesh.triangles});
    const bool is_solid = entry.track && entry.closed;
    std::erase_if(points, [&](Vec3 p) {
      return distance_within(tree.view(), p, clearance) < clearance ||
             (is_solid && is_inside(tree.view(), p));
    });
  });
}

}  // namespace meniscus
