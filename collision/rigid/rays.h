// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Rays against convex shapes in closed form. Bullet's own casts have an error of a millimetre or a
// centimetre, at any size.
#pragma once

#include <vector>

#include "collision/rigid/bullet.h"

namespace meniscus::collision {

struct ConvexRayHit {
  btScalar fraction;
  btVector3 normal;  ///< out of the shape
};

/// Half-spaces normal · p ≤ offset.
struct HullPlanes {
  struct Plane {
    btVector3 normal;
    btScalar offset;
  };
  std::vector<Plane> planes;
};

/// Whether a ray meets a shape nearer than hit.fraction, all in the shape's frame. A ray that starts inside
/// meets it at once. A hull's user pointer must point to its planes.
bool cast_ray_at(const btConvexShape& shape, const btVector3& from, const btVector3& to, ConvexRayHit& hit);

}  // namespace meniscus::collision
