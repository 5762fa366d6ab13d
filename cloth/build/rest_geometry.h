// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Lengths, areas and directions of triangles at rest, in double.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "cloth/build/cloth_mesh.h"

namespace meniscus::cloth {

inline Eigen::Vector3d to_double(Vec3 v) {
  return {v.x, v.y, v.z};
}

struct TriangleAtRest {
  Eigen::Vector3d normal;  ///< of length 1
  Eigen::Vector3d warp;    ///< in its plane, of length 1; 0 where the material coordinates give no direction
  double area;             ///< m²
};

/// `triangle` must have an area.
TriangleAtRest triangle_at_rest(const ClothMesh& mesh, uint32_t triangle);

std::vector<TriangleAtRest> triangles_at_rest(const ClothMesh& mesh);

}  // namespace meniscus::cloth
