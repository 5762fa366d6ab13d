// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The error of a distance field, and construction of a field to a target error.
#pragma once

#include "collision/sdf/build.h"

namespace meniscus::collision {

/// The default for the largest number of points of build_sdf_to_error: 256 MiB.
constexpr uint32_t max_sdf_points = 1u << 26;

/// The largest error of the trilinear field, m. It is measured at vertices, at midpoints of edges, at centres
/// of triangles, and at random points up to a cell from the surface along each axis. The points are the same
/// each time. Points with a winding number between 0.1 and 0.9 are skipped, because there the nearest surface
/// may close a hole.
template <class D>
float sdf_error(D& device, const TriangleMesh& mesh, const DeviceTriangleBvh& tree, const Sdf& field);

/// Builds the field of a mesh (see build_sdf) with cells small enough for an sdf_error of at most
/// target_error (m). The first cell is an eighth of the mesh's longest side, and it is halved as often as
/// needed. A wall thinner than a cell gives an error of about half of its thickness, so a target below that
/// resolves it. `tree` is the tree of `mesh`. Throws Error(invalid_argument) when target_error or margin (m)
/// is out of range, and Error(capacity) where max_points are too few.
template <class D>
Sdf build_sdf_to_error(D& device, const TriangleMesh& mesh, const DeviceTriangleBvh& tree, float target_error,
                       float margin, uint32_t max_points = max_sdf_points);

}  // namespace meniscus::collision
