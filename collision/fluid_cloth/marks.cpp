// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Computes the marks of triangles.
#include "collision/fluid_cloth/marks.h"

#include <algorithm>
#include <array>

#include "pbd/contacts.h"
#include "pbd/mesh_edges.h"

namespace meniscus::collision {

std::vector<uint32_t> triangle_marks(std::span<const pbd::SurfaceTriangle> triangles) {
  std::vector<std::array<uint32_t, 3>> corners;
  std::vector<uint32_t> place;
  uint32_t vertices = 0;
  for (uint32_t k = 0; k < triangles.size(); ++k) {
    const pbd::SurfaceTriangle& t = triangles[k];
    if (t.a == pbd::no_index) continue;
    corners.push_back({t.a, t.b, t.c});
    place.push_back(k);
    vertices = std::max({vertices, t.a + 1, t.b + 1, t.c + 1});
  }
  std::vector<uint32_t> marks(triangles.size());
  std::vector<bool> used(vertices);
  for (size_t t = 0; t < corners.size(); ++t) {
    for (uint32_t k = 0; k < 3; ++k) {
      if (!used[corners[t][k]]) marks[place[t]] |= 1u << (first_use_mark + k);
      used[corners[t][k]] = true;
    }
  }
  const std::vector<pbd::EdgeUse> uses = pbd::edge_uses(corners, vertices);
  pbd::for_each_edge(uses, [&](std::span<const pbd::EdgeUse> edge) {
    if (edge.size() != 1) return;
    const auto& corner = corners[edge[0].triangle];
    for (uint32_t k = 0; k < 3; ++k) {
      if (corner[(k + 2) % 3] == edge[0].opposite) marks[place[edge[0].triangle]] |= 1u << k;
    }
  });
  return marks;
}

}  // namespace meniscus::collision
