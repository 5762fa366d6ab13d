// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Directions across another one.
#pragma once

#include "pbd/math/vec.h"

namespace meniscus {

/// Two unit directions that are orthogonal to a unit normal and to each other.
struct Tangents {
  Vec3 u, v;

  MENISCUS_HD explicit Tangents(Vec3 normal) {
    const Vec3 axis = fabsf(normal.x) < 0.6f ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    u = normalized_or(cross(normal, axis), {0, 0, 0});
    v = cross(normal, u);
  }
};

}  // namespace meniscus
