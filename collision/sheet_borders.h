// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pbd/surface.h"

namespace meniscus::collision {

/// By triangle: bit k is set where its edge from corner k to the next belongs to no other triangle. Triangles
/// whose a is no_index are none.
std::vector<uint32_t> border_bits(std::span<const pbd::SurfaceTriangle> triangles);

}  // namespace meniscus::collision
