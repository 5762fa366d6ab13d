// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Finds open edges, non-manifold edges and self-intersections.
#include "collision/mesh/defects.h"

#include <algorithm>
#include <tuple>

#include "collision/mesh/crossings.h"
#include "pbd/mesh_edges.h"

namespace meniscus::collision {

using pbd::edge_uses;
using pbd::EdgeUse;
using pbd::for_each_edge;

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
    const uint32_t face = edge.front().triangle;
    if (edge.size() == 1) {
      defects.open_edges.push_back({face, face});
    } else if (edge.size() > 2 || edge[0].forward == edge[1].forward) {
      defects.non_manifold_edges.push_back({face, edge.back().triangle});
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
