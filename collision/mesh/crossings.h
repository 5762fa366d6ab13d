// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "collision/mesh/mesh.h"

namespace meniscus::collision {

/// Pairs of triangles, by number and in order, that share no vertex and pass through one another: a side of
/// one pierces the other, or the edge between two others. What merely touches does not count, nor what is
/// less than a millionth of the box's diagonal deep.
std::vector<std::pair<uint32_t, uint32_t>> crossing_triangles(const TriangleMesh& mesh);

}  // namespace meniscus::collision
