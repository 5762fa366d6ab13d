// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The points at which a distance field is measured, and the errors of a target that cannot be met.
#pragma once

#include <vector>

#include "collision/mesh/lattice.h"
#include "collision/mesh/mesh.h"

namespace meniscus::collision {

/// Vertices of triangles, midpoints of edges, centres of triangles.
std::vector<Vec3> points_on_surface(const TriangleMesh& mesh);

/// `count` points, distributed by area over the surface, then moved by up to `reach` (m) along each axis. The
/// same each time.
std::vector<Vec3> points_near_surface(const TriangleMesh& mesh, uint32_t count, float reach);

/// The number of points of the lattice around a box (see lattice_around), which may exceed the largest
/// possible one.
double lattice_points_around(const Aabb& box, float spacing, float margin);

/// Throws Error(invalid_argument) for a target that is not positive, or a negative margin.
void check_error_target(float target_error, float margin);

/// Throws Error(capacity): the last field has this `error`, and the next one would have too many points.
[[noreturn]] void refuse_error_target(float target_error, float error, float cell_size, double points,
                                      uint32_t max_points);

}  // namespace meniscus::collision
