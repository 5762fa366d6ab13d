// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// How a piece of cloth collides with cloth.
#pragma once

#include "pbd/filter.h"

namespace meniscus::cloth {

/// How the triangles of one piece collide with other pieces and with one another.
struct ContactPiece {
  float thickness = 0.01f;   ///< m, > 0: two pieces keep half the sum of their thicknesses
  float friction = 0.3f;     ///< Coulomb's μ, ≥ 0; two pieces use the geometric mean
  CollisionFilter filter{};  ///< which other pieces it collides with
  bool self = true;          ///< whether it collides with itself
};

}  // namespace meniscus::cloth
