// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Rebuilds a closed surface from a mesh with holes or crossings.
#pragma once

#include "collision/mesh/mesh.h"

namespace meniscus::collision {

/// A closed, simple surface in place of a mesh, with how well it agrees.
struct RepairedMesh {
  TriangleMesh mesh;
  float cell_size = 0;       ///< m: no part of either surface is further from the other
  double volume_before = 0;  ///< m³, inside the old outer surface; fans close the holes
  double volume = 0;         ///< m³, of the new mesh
  float deviation = 0;       ///< m, the largest distance from a point of the old outer surface to the new one
};

/// Builds the mesh's distance field, whose sign is the winding number's, and takes its surface by marching
/// cubes. That closes holes and drops what lies inside. Each vertex is on an edge of the grid that the
/// surface crosses. The first grid has cells of `cell_size` (m). They are halved until no part of the old
/// outer surface is further than `cell_size` from the new one: a sharp tip always loses more than a cell of
/// its grid. The finest cells are an
/// eighth. Grids have at most 2^22 points: `cell_size` grows for a wider mesh. Throws Error(mesh), with a
/// text that begins with `what`, if there is no inside, or walls are too thin.
RepairedMesh repair_mesh(const TriangleMesh& mesh, float cell_size, const std::string& what);

}  // namespace meniscus::collision
