// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "collision/mesh/mesh.h"

namespace meniscus::collision {

/// Welds vertices nearer than a millionth of the box's diagonal, then drops triangles without area, triangles
/// that are there twice, and vertices that no triangle uses. What is left keeps its order. Vertices must be
/// finite.
TriangleMesh clean_mesh(const TriangleMesh& mesh);

/// A clean mesh that knows where its triangles come from.
struct CleanedMesh {
  TriangleMesh mesh;
  std::vector<uint32_t> sources;  ///< the number that each triangle had
};
CleanedMesh clean_mesh_with_sources(const TriangleMesh& mesh);

}  // namespace meniscus::collision
