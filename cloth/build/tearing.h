// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tearing: a vertex becomes two or more, and the triangles around it part ways (Müller, Heidelberger, Hennix
// & Ratcliff 2007). All triangles and their area are kept. What was a surface with a border still
// is: a vertex whose triangles would hang together at that point alone is taken apart as well.
#pragma once

#include <span>
#include <vector>

#include "cloth/build/cloth_mesh.h"

namespace meniscus::cloth {

/// A vertex that tearing has added: the mesh's vertices `copy` and `original` were one.
struct TornVertex {
  uint32_t copy, original;
};

/// Splits `vertex` along the plane through it with this normal: triangles with their centre beyond the plane
/// part from those on its near side. `positions` of the mesh's vertices, m, say where triangles are now. Adds
/// one vertex to the mesh for each that it returns, with the original's place at rest and material
/// coordinates; empty where there was nothing to part. Throws Error(invalid_argument) for a vertex that is
/// not there or positions that are not one a vertex.
std::vector<TornVertex> tear(ClothMesh& mesh, uint32_t vertex, std::span<const Vec3> positions, Vec3 normal);

struct OverstretchedEdge {
  uint32_t a, b;
  float stretch;  ///< the larger, the sooner it tears
};

/// Splits one end of each of these edges along the plane through it that the edge is perpendicular to: the
/// most stretched first, no more than `most_splits` of them. The end with more stretch around it is tried
/// first. What shares a triangle with a vertex split in this call waits for the next. Throws as `tear` does.
std::vector<TornVertex> tear_along(ClothMesh& mesh, std::span<const Vec3> positions,
                                   std::span<const OverstretchedEdge> edges, uint32_t most_splits);

}  // namespace meniscus::cloth
