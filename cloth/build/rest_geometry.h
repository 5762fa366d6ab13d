// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Areas and directions of triangles at rest, in double precision.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "cloth/build/cloth_mesh.h"

namespace meniscus::cloth {

inline Eigen::Vector3d to_double(Vec3 v) {
  return {v.x, v.y, v.z};
}

struct TriangleAtRest {
  Eigen::Vector3d normal;  ///< unit vector
  Eigen::Vector3d warp;    ///< unit vector in its plane; 0 where the material coordinates give no direction
  double area;             ///< m²
};

/// `triangle` must have an area greater than 0.
TriangleAtRest triangle_at_rest(const ClothMesh& mesh, uint32_t triangle);

std::vector<TriangleAtRest> triangles_at_rest(const ClothMesh& mesh);

}  // namespace meniscus::cloth
