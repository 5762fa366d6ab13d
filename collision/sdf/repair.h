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
  float cell_size = 0;       ///< m, of the grid
  double volume_before = 0;  ///< m³, inside the old outer surface; fans close the holes
  double volume = 0;         ///< m³, of the new mesh
  float deviation = 0;       ///< m, the largest distance from a point of the old outer surface to the new one
};

/// Builds the mesh's distance field, whose sign is the winding number's, and takes its surface by marching
/// cubes. That closes holes and drops what lies inside. Each vertex is on an edge of the grid that the
/// surface crosses, so it is no further than a cell from it. Cells are `cell_size` (m), and are halved until
/// no part of the old outer surface is further than a cell from the new one. Grids have at most 2^22 points:
/// a wider mesh gets larger cells. Throws Error(mesh), with a text that begins with `what`, if there is no
/// inside, or walls are too thin.
RepairedMesh repair_mesh(const TriangleMesh& mesh, float cell_size, const std::string& what);

}  // namespace meniscus::collision
