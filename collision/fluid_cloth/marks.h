// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pbd/surface_tree/surface.h"

namespace meniscus::collision {

/// Bit k of a triangle's marks: its edge from corner k to the next belongs to no other triangle.
inline constexpr uint32_t border_marks = 7;
/// Bit first_use_mark + k: no triangle before it has the vertex at its corner k. Who looks through triangles
/// comes upon each vertex once.
inline constexpr uint32_t first_use_mark = 3;

/// By triangle. Those whose a is no_index are none.
std::vector<uint32_t> triangle_marks(std::span<const pbd::SurfaceTriangle> triangles);

}  // namespace meniscus::collision
