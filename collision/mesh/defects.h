// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Defects that keep a mesh from bounding a solid.
#pragma once

#include <vector>

#include "collision/mesh/mesh.h"

namespace meniscus::collision {

/// A defect that keeps a mesh from bounding a solid.
struct MeshDefect {
  uint32_t face;   ///< the number of a triangle
  uint32_t other;  ///< another triangle of the defect; for an open edge the same one
};

/// Each list is sorted by face and lists each edge or pair once, at the lowest of its faces.
struct MeshDefects {
  std::vector<MeshDefect> open_edges;          ///< that belong to one face alone
  std::vector<MeshDefect> non_manifold_edges;  ///< of three faces or more, or two that disagree
  std::vector<MeshDefect> self_intersections;  ///< faces that share no vertex and cross

  bool none() const { return open_edges.empty() && non_manifold_edges.empty() && self_intersections.empty(); }
};

/// Expects a mesh without degenerate or repeated triangles (clean_mesh).
MeshDefects find_defects(const TriangleMesh& mesh);

}  // namespace meniscus::collision
