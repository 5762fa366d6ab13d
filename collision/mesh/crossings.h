// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Self-intersections of a mesh.
#pragma once

#include <utility>
#include <vector>

#include "collision/mesh/mesh.h"

namespace meniscus::collision {

/// Pairs of triangles that share no vertex and pass through one another, sorted by number. A side of one
/// pierces the other, or passes through the edge between two others. Contact alone does not count, nor does a
/// depth of less than a millionth of the box's diagonal.
std::vector<std::pair<uint32_t, uint32_t>> crossing_triangles(const TriangleMesh& mesh);

}  // namespace meniscus::collision
