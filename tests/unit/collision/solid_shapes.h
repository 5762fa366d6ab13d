// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Solids made of boxes, for tests.
#pragma once

#include <utility>

#include "tests/unit/collision/mesh_shapes.h"

namespace meniscus::collision {

/// Both meshes as one, without welding.
inline TriangleMesh joined(TriangleMesh mesh, const TriangleMesh& other) {
  const auto first = static_cast<uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& [a, b, c] : other.triangles) mesh.triangles.push_back({a + first, b + first, c + first});
  return mesh;
}

inline TriangleMesh inside_out(TriangleMesh mesh) {
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

inline TriangleMesh placed(TriangleMesh mesh, const Pose& pose) {
  for (Vec3& v : mesh.vertices) v = to_world(pose, v);
  return mesh;
}

/// A cube of half an edge `half` around the middle of the origin and its top, open there, with walls and a
/// bottom of this thickness: outside from (−half, 0, −half) to (half, 2 half, half).
inline TriangleMesh cup_mesh(float half, float wall) {
  const auto without_top = [](TriangleMesh box) {
    std::erase_if(box.triangles, [](const auto& t) { return (t[0] & t[1] & t[2] & 2) != 0; });
    return box;
  };
  const float inner = half - wall;
  TriangleMesh cup =
      joined(without_top(box_mesh({-half, 0, -half}, {half, 2 * half, half})),
             inside_out(without_top(box_mesh({-inner, wall, -inner}, {inner, 2 * half, inner}))));
  const uint32_t rim[] = {2, 6, 7, 3};
  for (int k = 0; k < 4; ++k) {
    const uint32_t a = rim[k], b = rim[(k + 1) % 4];
    cup.triangles.insert(cup.triangles.end(), {{a, b, b + 8}, {a, b + 8, a + 8}});
  }
  return cup;
}

}  // namespace meniscus::collision
