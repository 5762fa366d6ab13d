// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "collision/sdf/build.h"

namespace meniscus::collision {

/// The most points that build_sdf_to_error takes unless told otherwise: 256 MiB.
constexpr uint32_t max_sdf_points = 1u << 26;

/// How far the trilinear field is off at most, m: at the mesh's vertices, the middles of its edges and
/// triangles, and at points strewn over its surface, up to a cell away along each axis, the same each time.
/// Points where the winding number is between 0.1 and 0.9 are passed over: there the nearest surface may be
/// what closes a hole.
template <class D>
float sdf_error(D& device, const TriangleMesh& mesh, const DeviceTriangleBvh& tree, const Sdf& field);

/// The field of a mesh (see build_sdf) with cells small enough for an sdf_error of at most target_error (m):
/// an eighth of the mesh's longest side, halved as often as it takes. A wall thinner than a cell is an error
/// of about half of its thickness, so that a target below that resolves it. `tree` is the tree of `mesh`.
/// Throws Error(invalid_argument) when target_error or margin (m) is out of range, Error(capacity) where
/// max_points are too few.
template <class D>
Sdf build_sdf_to_error(D& device, const TriangleMesh& mesh, const DeviceTriangleBvh& tree, float target_error,
                       float margin, uint32_t max_points = max_sdf_points);

}  // namespace meniscus::collision
