// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Sorts the edges of a triangle mesh.
#include "pbd/mesh_edges.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace meniscus::pbd {

std::vector<EdgeUse> edge_uses(std::span<const std::array<uint32_t, 3>> triangles, size_t vertices) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * triangles.size());
  for (uint32_t t = 0; t < triangles.size(); ++t) {
    const auto& corners = triangles[t];
    for (uint32_t k = 0; k < 3; ++k) {
      const uint32_t from = corners[k], to = corners[(k + 1) % 3], third = corners[(k + 2) % 3];
      uses.push_back({std::min(from, to), std::max(from, to), t, third, from < to});
    }
  }
  // A counting sort by the lower vertex, then a comparison sort of the few edges of each vertex.
  std::vector<uint32_t> starts(vertices + 1, 0);
  for (const EdgeUse& u : uses) ++starts[u.low + 1];
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  std::vector<EdgeUse> sorted(uses.size());
  std::vector<uint32_t> next(starts.begin(), starts.end() - 1);
  for (const EdgeUse& u : uses) sorted[next[u.low]++] = u;
  for (size_t v = 0; v < vertices; ++v) {
    std::sort(sorted.begin() + starts[v], sorted.begin() + starts[v + 1],
              [](const EdgeUse& a, const EdgeUse& b) {
                return std::tie(a.high, a.triangle) < std::tie(b.high, b.triangle);
              });
  }
  return sorted;
}

}  // namespace meniscus::pbd
