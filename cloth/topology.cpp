// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "cloth/topology.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace meniscus::cloth {

std::vector<EdgeUse> edge_uses(const ClothMesh& mesh) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * mesh.triangles.size());
  for (uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& corners = mesh.triangles[t];
    for (uint32_t k = 0; k < 3; ++k) {
      const uint32_t from = corners[k], to = corners[(k + 1) % 3], third = corners[(k + 2) % 3];
      uses.push_back({std::min(from, to), std::max(from, to), t, third, from < to});
    }
  }
  // By low with counts, then each vertex's few by comparison.
  std::vector<uint32_t> starts(mesh.vertices.size() + 1, 0);
  for (const EdgeUse& u : uses) ++starts[u.low + 1];
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  std::vector<EdgeUse> sorted(uses.size());
  std::vector<uint32_t> next(starts.begin(), starts.end() - 1);
  for (const EdgeUse& u : uses) sorted[next[u.low]++] = u;
  for (size_t v = 0; v < mesh.vertices.size(); ++v) {
    std::sort(sorted.begin() + starts[v], sorted.begin() + starts[v + 1],
              [](const EdgeUse& a, const EdgeUse& b) {
                return std::tie(a.high, a.triangle) < std::tie(b.high, b.triangle);
              });
  }
  return sorted;
}

VertexTriangles::VertexTriangles(const ClothMesh& mesh) : starts_(mesh.vertices.size() + 1, 0) {
  for (const auto& t : mesh.triangles) {
    for (uint32_t v : t) ++starts_[v + 1];
  }
  std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
  triangles_.resize(starts_.back());
  std::vector<uint32_t> next(starts_.begin(), starts_.end() - 1);
  for (uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (uint32_t v : mesh.triangles[t]) triangles_[next[v]++] = t;
  }
}

}  // namespace meniscus::cloth
