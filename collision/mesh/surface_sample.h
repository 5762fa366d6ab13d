// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <meniscus/types.h>

namespace meniscus::collision {

/// What a point sees of the nearest solid surface.
struct SurfaceSample {
  float distance;  ///< m, positive outside
  Vec3 normal;     ///< unit, pointing out of the solid
};

}  // namespace meniscus::collision
