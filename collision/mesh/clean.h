// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cleaning of meshes: welded vertices, no degenerate or repeated triangles.
#pragma once

#include "collision/mesh/mesh.h"

namespace meniscus::collision {

/// Welds vertices nearer than a millionth of the box's diagonal. Then drops triangles without area, repeated
/// triangles and vertices that no triangle uses. The rest keeps its order. Vertices must be finite.
TriangleMesh clean_mesh(const TriangleMesh& mesh);

/// A clean mesh with the origin of its triangles.
struct CleanedMesh {
  TriangleMesh mesh;
  std::vector<uint32_t> sources;         ///< by triangle: its number in the original mesh
  std::vector<uint32_t> vertex_sources;  ///< by vertex: likewise
  size_t welded = 0;                     ///< places of vertices that were merged into those of others
  size_t dropped = 0;                    ///< triangles without area, or repeated
};
CleanedMesh clean_mesh_with_sources(const TriangleMesh& mesh);

/// The clean mesh of a file, with faces turned outwards, as load_mesh returns it. Throws as that does.
CleanedMesh load_cleaned_mesh(const MeshSource& source);

}  // namespace meniscus::collision
