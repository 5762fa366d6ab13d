// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Which faces meet at which edge.
#pragma once

#include <span>
#include <vector>

#include "collision/mesh.h"

namespace meniscus::collision {

/// One side of a triangle.
struct EdgeUse {
  uint32_t low, high;  ///< vertices, low < high
  uint32_t face;
  bool forward;  ///< the face runs from low to high
};

/// All sides of all triangles, sorted by edge, then by face.
std::vector<EdgeUse> edge_uses(const TriangleMesh& mesh);

/// Calls visit(std::span<const EdgeUse>) for each edge, with the faces that meet there.
template <class Visit>
void for_each_edge(std::span<const EdgeUse> uses, const Visit& visit) {
  for (size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    while (end < uses.size() && uses[end].low == uses[begin].low && uses[end].high == uses[begin].high) ++end;
    visit(uses.subspan(begin, end - begin));
  }
}

}  // namespace meniscus::collision
