// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tearing: a vertex becomes two or more, and the triangles around it part (Müller, Heidelberger, Hennix &
// Ratcliff 2007). All triangles and their areas are kept. A surface with a border remains one: a vertex whose
// triangles are connected only at that point is split as well.
#pragma once

#include <span>
#include <vector>

#include "cloth/build/cloth_mesh.h"

namespace meniscus::cloth {

/// A vertex that tearing has added. The vertices `copy` and `original` of the mesh were one.
struct TornVertex {
  uint32_t copy, original;
};

/// Splits `vertex` along the plane through it with this normal. Triangles with their centre beyond the plane
/// part from those on its near side. `positions` (m) are the present positions of the mesh's vertices. Adds
/// to the mesh each vertex that it returns, with the rest position and material coordinates of the original.
/// Returns nothing if nothing parted. Throws Error(invalid_argument) for a vertex that does not exist, or for
/// positions that are not one per vertex.
std::vector<TornVertex> tear(ClothMesh& mesh, uint32_t vertex, std::span<const Vec3> positions, Vec3 normal);

struct OverstretchedEdge {
  uint32_t a, b;
  float stretch;  ///< the larger, the sooner it tears
};

/// Splits one end of each of these edges, along the plane through that end and perpendicular to the edge. The
/// most stretched edges come first, and at most `most_splits` are split. The end with more stretch around it
/// is tried first. A vertex that shares a triangle with one split in this call waits for the next call.
/// Throws as `tear` does.
std::vector<TornVertex> tear_along(ClothMesh& mesh, std::span<const Vec3> positions,
                                   std::span<const OverstretchedEdge> edges, uint32_t most_splits);

}  // namespace meniscus::cloth
