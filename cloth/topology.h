// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What hangs together with what in a mesh of triangles.
#pragma once

#include <span>
#include <vector>

#include "cloth/cloth_mesh.h"

namespace meniscus::cloth {

inline constexpr uint32_t none = 0xffffffff;

/// One side of a triangle.
struct EdgeUse {
  uint32_t low, high;  ///< vertices, low < high
  uint32_t triangle;
  uint32_t opposite;  ///< the triangle's third vertex
  bool forward;       ///< the triangle runs from low to high
};

/// All sides of all triangles, sorted by edge (low, then high), then by triangle.
std::vector<EdgeUse> edge_uses(const ClothMesh& mesh);

/// Calls visit(std::span<const EdgeUse>) for each edge, with the triangles that meet there.
template <class Visit>
void for_each_edge(std::span<const EdgeUse> uses, const Visit& visit) {
  for (size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    while (end < uses.size() && uses[end].low == uses[begin].low && uses[end].high == uses[begin].high) ++end;
    visit(uses.subspan(begin, end - begin));
  }
}

/// The triangles at each vertex, in their order.
class VertexTriangles {
 public:
  explicit VertexTriangles(const ClothMesh& mesh);

  std::span<const uint32_t> of(uint32_t vertex) const {
    return std::span(triangles_).subspan(starts_[vertex], starts_[vertex + 1] - starts_[vertex]);
  }

 private:
  std::vector<uint32_t> starts_;
  std::vector<uint32_t> triangles_;
};

}  // namespace meniscus::cloth
