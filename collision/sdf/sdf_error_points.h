// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Where a distance field is held to account, and what is said when it cannot be good enough.
#pragma once

#include <vector>

#include "collision/mesh/lattice.h"
#include "collision/mesh/mesh.h"

namespace meniscus::collision {

/// Vertices of triangles, middles of edges, middles of triangles.
std::vector<Vec3> points_on_surface(const TriangleMesh& mesh);

/// `count` points, by area over the surface, then moved by up to `reach` (m) along each axis. The same each
/// time.
std::vector<Vec3> points_near_surface(const TriangleMesh& mesh, uint32_t count, float reach);

/// How many points the lattice around a box has (see lattice_around), which may be beyond what one can have.
double lattice_points_around(const Aabb& box, float spacing, float margin);

/// Throws Error(invalid_argument) for a target that is not positive, or a negative margin.
void check_error_target(float target_error, float margin);

/// Throws Error(capacity): the last field was off by `error`, the next one would have too many points.
[[noreturn]] void refuse_error_target(float target_error, float error, float cell_size, double points,
                                      uint32_t max_points);

}  // namespace meniscus::collision
