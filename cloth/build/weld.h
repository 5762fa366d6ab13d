// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Merges vertices of a cloth mesh that lie within a distance.
#pragma once

#include "cloth/build/cloth_mesh.h"

namespace meniscus::cloth {

/// Merges vertices no further apart than `distance`, in m, and all that such pairs connect. The position with
/// the least (x, y, z) stays, so the shape does not depend on the vertices' order. Triangles that lose a
/// corner are dropped. Vertices close up in their old order. The mesh must have no material coordinates, and
/// triangles with a vertex that does not exist stay. Returns how many vertices are gone. `dropped` receives
/// the numbers of dropped triangles, in ascending order.
uint32_t weld(ClothMesh& mesh, double distance, std::vector<uint32_t>* dropped = nullptr);

}  // namespace meniscus::cloth
