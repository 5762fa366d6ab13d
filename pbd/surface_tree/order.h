// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The order of the triangles in the tree of boxes.
#pragma once

#include <span>
#include <vector>

#include "pbd/surface_tree/surface.h"

namespace meniscus::pbd {

/// The triangle at each place of the tree. Neighbours in space are adjacent, and no group of eight has
/// triangles of two pieces; the last group of a piece is padded with no_index. It is found once for a
/// surface, because triangles that are near in the material stay near.
std::vector<uint32_t> tree_order(std::span<const SurfaceTriangle> triangles, std::span<const Vec3> positions);

}  // namespace meniscus::pbd
