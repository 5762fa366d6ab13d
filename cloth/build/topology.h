// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The connections between the triangles, edges and vertices of a mesh.
#pragma once

#include <span>
#include <vector>

#include "cloth/build/cloth_mesh.h"
#include "pbd/mesh_edges.h"

namespace meniscus::cloth {

using pbd::edge_uses;
using pbd::EdgeUse;
using pbd::for_each_edge;

inline constexpr uint32_t none = 0xffffffff;

/// The triangles at each vertex, in ascending order.
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
