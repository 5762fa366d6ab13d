// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "collision/mesh_defects.h"

#include <algorithm>
#include <tuple>

#include "collision/mesh_crossings.h"
#include "collision/mesh_edges.h"

namespace meniscus::collision {

namespace {

void sort_by_face(std::vector<MeshDefect>& defects) {
  std::sort(defects.begin(), defects.end(), [](const MeshDefect& a, const MeshDefect& b) {
    return std::tie(a.face, a.other) < std::tie(b.face, b.other);
  });
}

}  // namespace

MeshDefects find_defects(const TriangleMesh& mesh) {
  MeshDefects defects;
  for_each_edge(edge_uses(mesh), [&](std::span<const EdgeUse> edge) {
    const uint32_t face = edge.front().face;
    if (edge.size() == 1) {
      defects.open_edges.push_back({face, face});
    } else if (edge.size() > 2 || edge[0].forward == edge[1].forward) {
      defects.non_manifold_edges.push_back({face, edge.back().face});
    }
  });
  sort_by_face(defects.open_edges);
  sort_by_face(defects.non_manifold_edges);
  for (const auto& [face, other] : crossing_triangles(mesh)) {
    defects.self_intersections.push_back({face, other});
  }
  return defects;
}

}  // namespace meniscus::collision
