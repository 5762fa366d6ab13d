// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Builds the list of triangles at each vertex.
#include "cloth/build/topology.h"

#include <numeric>

namespace meniscus::cloth {

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
