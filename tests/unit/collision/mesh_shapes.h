// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Meshes with known answers, for tests.
#pragma once

#include <algorithm>
#include <map>

#include "collision/mesh/mesh.h"
#include "pbd/math/vec.h"

namespace meniscus::collision {

/// Splits each triangle in four and puts the new vertices on the unit sphere.
inline TriangleMesh refined_on_sphere(const TriangleMesh& coarse) {
  TriangleMesh fine{coarse.vertices, {}};
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
  const auto middle = [&](uint32_t a, uint32_t b) {
    const auto key = std::minmax(a, b);
    const auto [place, fresh] = middles.try_emplace(key, static_cast<uint32_t>(fine.vertices.size()));
    if (fresh) fine.vertices.push_back(normalized_or(fine.vertices[a] + fine.vertices[b], {0, 1, 0}));
    return place->second;
  };
  for (const auto& [a, b, c] : coarse.triangles) {
    const uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    fine.triangles.insert(fine.triangles.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
  }
  return fine;
}

/// A ball around the origin: an octahedron refined `levels` times, 8 · 4^levels triangles.
inline TriangleMesh ball_mesh(float radius, int levels) {
  TriangleMesh mesh;
  mesh.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = 0; level < levels; ++level) mesh = refined_on_sphere(mesh);
  for (Vec3& v : mesh.vertices) v = radius * v;
  return mesh;
}

/// The ball without its triangles that lie wholly above `height`.
inline TriangleMesh open_ball_mesh(float radius, int levels, float height) {
  TriangleMesh mesh = ball_mesh(radius, levels);
  std::erase_if(mesh.triangles, [&](const auto& t) {
    return mesh.vertices[t[0]].y > height && mesh.vertices[t[1]].y > height && mesh.vertices[t[2]].y > height;
  });
  return mesh;
}

/// An axis-aligned box.
inline TriangleMesh box_mesh(Vec3 lower, Vec3 upper) {
  TriangleMesh mesh;
  for (int corner = 0; corner < 8; ++corner) {
    mesh.vertices.push_back(
        {corner & 1 ? upper.x : lower.x, corner & 2 ? upper.y : lower.y, corner & 4 ? upper.z : lower.z});
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 4, 6}, {0, 6, 2},
                    {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3}};
  return mesh;
}

/// Numbers in [0, 1) that are the same on every platform.
class Noise {
 public:
  explicit Noise(uint32_t seed) : state_(seed) {}

  float next() {
    state_ = state_ * 1664525u + 1013904223u;
    return static_cast<float>(state_ >> 8) * 0x1p-24f;
  }
  Vec3 in_cube(float half) {
    const float x = next(), y = next(), z = next();
    return 2 * half * (Vec3{x, y, z} - Vec3{0.5f, 0.5f, 0.5f});
  }

 private:
  uint32_t state_;
};

}  // namespace meniscus::collision
