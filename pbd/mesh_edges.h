// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The edges of a triangle mesh, with the triangles that share each.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace meniscus::pbd {

/// An edge as one triangle uses it.
struct EdgeUse {
  uint32_t low, high;  ///< vertices, low < high
  uint32_t triangle;
  uint32_t opposite;  ///< the triangle's third vertex
  bool forward;       ///< the triangle runs from low to high
};

/// Three uses for each triangle, sorted by edge and then by triangle.
std::vector<EdgeUse> edge_uses(std::span<const std::array<uint32_t, 3>> triangles, size_t vertices);

template <class Mesh>
std::vector<EdgeUse> edge_uses(const Mesh& mesh) {
  return edge_uses(mesh.triangles, mesh.vertices.size());
}

/// Calls visit(std::span<const EdgeUse>) for each edge, with the triangles that share it.
template <class Visit>
void for_each_edge(std::span<const EdgeUse> uses, const Visit& visit) {
  for (size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    while (end < uses.size() && uses[end].low == uses[begin].low && uses[end].high == uses[begin].high) ++end;
    visit(uses.subspan(begin, end - begin));
  }
}

}  // namespace meniscus::pbd
