// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Builds the adjacency lists of a model, and finds the damping that all pieces share.
#include "cloth/build/cloth_model.h"

#include <numeric>

namespace meniscus::cloth {

namespace {

/// Builds CSR adjacency: item k belongs to vertex_of(k).
template <class VertexOf>
Adjacency adjacency(size_t items, size_t vertices, const VertexOf& vertex_of) {
  Adjacency by_vertex{std::vector<uint32_t>(vertices + 1), std::vector<uint32_t>(items)};
  for (uint32_t k = 0; k < items; ++k) ++by_vertex.start[vertex_of(k) + 1];
  std::partial_sum(by_vertex.start.begin(), by_vertex.start.end(), by_vertex.start.begin());
  std::vector<uint32_t> next(by_vertex.start.begin(), by_vertex.start.end() - 1);
  for (uint32_t k = 0; k < items; ++k) by_vertex.items[next[vertex_of(k)]++] = k;
  return by_vertex;
}

}  // namespace

Adjacency corners_by_vertex(const std::vector<pbd::SurfaceTriangle>& triangles, size_t vertices) {
  return adjacency(3 * triangles.size(), vertices, [&](uint32_t k) {
    const pbd::SurfaceTriangle& t = triangles[k / 3];
    return k % 3 == 0 ? t.a : k % 3 == 1 ? t.b : t.c;
  });
}

Adjacency edge_ends_by_vertex(const std::vector<EdgeConstraint>& edges, size_t vertices) {
  return adjacency(2 * edges.size(), vertices,
                   [&](uint32_t k) { return k % 2 == 0 ? edges[k / 2].a : edges[k / 2].b; });
}

CommonDamping common_damping(const std::vector<Piece>& pieces) {
  const auto common = [&](float Piece::*damping) {
    float value = -1;
    for (const Piece& p : pieces) {
      if (p.*damping < 0 || p.*damping == value) continue;
      if (value >= 0) return -1.0f;
      value = p.*damping;
    }
    return value;
  };
  return {common(&Piece::stretch_damping), common(&Piece::bending_damping)};
}

}  // namespace meniscus::cloth
