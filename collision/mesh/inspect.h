// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What there is to say of a mesh file.
#pragma once

#include <string>

#include "collision/mesh/mesh.h"

namespace meniscus::collision {

struct MeshReport {
  Aabb box{};                  ///< m
  std::size_t triangles = 0;   ///< after cleaning
  std::size_t welded = 0;      ///< places of vertices that were merged into those of others
  std::size_t dropped = 0;     ///< triangles without area, or repeated
  std::size_t holes = 0;       ///< groups of open edges that hang together
  std::size_t open_edges = 0;  ///< edges of one triangle
  std::size_t odd_edges = 0;   ///< edges of more than two triangles, or of two that disagree
  std::size_t crossings = 0;   ///< pairs of triangles that cross
  double volume = 0;           ///< m³; holes count as closed by cones
};

/// Throws what load_mesh throws.
MeshReport inspect_mesh(const std::string& path, float scale);

/// "metres", "centimetres", "millimetres" or "unknown": the largest unit in which this longest side is one of
/// 2 cm to 20 m.
const char* unit_guess(float longest_side);

}  // namespace meniscus::collision
