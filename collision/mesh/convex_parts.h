// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Convex parts that stand for a concave solid.
#pragma once

#include <vector>

#include "collision/mesh/mesh.h"

namespace meniscus::collision {

struct ConvexParts {
  std::vector<TriangleMesh> hulls;  ///< at least one
  double excess = 0;                ///< m³, by which they exceed the solid
};

/// Cuts a closed mesh whose triangles face outwards (load_solid) into at most `most` parts. Each part is what
/// the solid has in a box, and its hull stands for it. A box whose hull exceeds its part the most is cut
/// next, by the plane along an axis that leaves the least volume in both hulls. This ends when no hull
/// exceeds its part by more than a thousandth of the whole hull. A convex mesh is one part. Throws
/// Error(mesh) where the mesh has no volume.
ConvexParts convex_parts(const TriangleMesh& mesh, int most);

}  // namespace meniscus::collision
