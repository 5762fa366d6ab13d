// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Marks of triangles of cloth: border edges, and the first triangle that uses a vertex.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pbd/surface_tree/surface.h"

namespace meniscus::collision {

/// Bit k of a triangle's marks: its edge from corner k to the next belongs to no other triangle.
inline constexpr uint32_t border_marks = 7;
/// Bit first_use_mark + k: no earlier triangle has the vertex at its corner k. A loop over triangles can so
/// visit each vertex once.
inline constexpr uint32_t first_use_mark = 3;

/// The marks of each triangle. Entries with a = no_index are no triangles.
std::vector<uint32_t> triangle_marks(std::span<const pbd::SurfaceTriangle> triangles);

}  // namespace meniscus::collision
