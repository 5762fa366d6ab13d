// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The distance and normal of the nearest solid surface.
#pragma once

#include <meniscus/types.h>

namespace meniscus::collision {

/// The nearest solid surface, as seen from a point.
struct SurfaceSample {
  float distance;  ///< m, positive outside
  Vec3 normal;     ///< unit, pointing out of the solid
};

}  // namespace meniscus::collision
