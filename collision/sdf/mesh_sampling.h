// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of points against the inside of a mesh.
#pragma once

#include <span>
#include <vector>

#include "collision/mesh/triangle_bvh.h"

namespace meniscus::collision {

/// For each point 1 if it is inside the mesh by the winding number, otherwise 0.
template <class D>
std::vector<uint8_t> points_inside(D& device, const DeviceTriangleBvh& mesh, std::span<const Vec3> points);

/// The points of a cubic lattice that are inside the mesh, x fastest: see lattice_within.
/// Throws Error(invalid_argument) when the spacing (m) is not positive or gives the mesh's box too many
/// points.
template <class D>
std::vector<Vec3> lattice_points_inside(D& device, const DeviceTriangleBvh& mesh, float spacing);

}  // namespace meniscus::collision
