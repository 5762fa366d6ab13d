// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Makes the coloured triangles of solids.
#include "sdk/io/solid_triangles.h"
#include "sdk/render/meshes/mesh.h"

namespace meniscus::render {

bool is_floor(Vec3 inwards, const Pose& pose, Vec3 up) {
  return dot(rotate(pose.rotation, inwards), up) > 0.7f;
}

Triangles solid_surface(const Geometry& geometry, const Pose& pose, Vec3 up, Vec3 color) {
  Triangles all;
  const bool floors_alone = std::holds_alternative<ContainerGeometry>(geometry);
  for (const io::SolidTriangle& t : io::solid_triangles(geometry)) {
    if (floors_alone && !is_floor(t.normals[0], pose, up)) continue;
    const Float4 look = float4(t.color.value_or(color), static_cast<float>(Look::glossy));
    for (int k = 0; k < 3; ++k) all.push_back({t.corners[k], t.normals[k], look, {}});
  }
  return all;
}

}  // namespace meniscus::render
