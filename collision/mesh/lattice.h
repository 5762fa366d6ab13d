// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cubic lattices, as the nodes of grids and as positions of particles.
#pragma once

#include <cstdint>

#include "pbd/math/vec.h"

namespace meniscus::collision {

/// Points of a cubic lattice, x fastest.
struct Lattice {
  Vec3 origin;          ///< m, the first point
  float spacing;        ///< m
  uint32_t nx, ny, nz;  ///< points along each axis

  MENISCUS_HD uint32_t count() const { return nx * ny * nz; }
  MENISCUS_HD uint32_t index(uint32_t i, uint32_t j, uint32_t k) const { return (k * ny + j) * nx + i; }
  MENISCUS_HD Vec3 point(uint32_t i, uint32_t j, uint32_t k) const {
    return origin + spacing * Vec3{static_cast<float>(i), static_cast<float>(j), static_cast<float>(k)};
  }
  MENISCUS_HD Vec3 point(uint32_t at) const { return point(at % nx, at / nx % ny, at / nx / ny); }
};

/// The largest number of points of a lattice.
constexpr uint32_t max_lattice_points = 1u << 28;

/// A lattice with the same centre as the box. It reaches `margin` and half a spacing beyond the box on all
/// sides. Throws Error(invalid_argument), with `name` for the spacing, when that is not positive or gives too
/// many points.
Lattice lattice_around(const Aabb& box, float spacing, float margin, const char* name);

/// Centres of the cubes of edge `spacing` around the box's centre. Their number along each side fits the box
/// best, so a box of whole multiples is filled exactly. Throws like lattice_around.
Lattice lattice_within(const Aabb& box, float spacing, const char* name);

}  // namespace meniscus::collision
