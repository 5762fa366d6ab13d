// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "pbd/surface_tree/surface.h"

namespace meniscus::pbd {

/// Which triangle stands at each place of the tree: neighbours in space come together, and no group of eight
/// holds triangles of two parts, but no_index where a part's last group has room left. Found once for a
/// surface: what is near in the material stays near.
std::vector<uint32_t> tree_order(std::span<const SurfaceTriangle> triangles, std::span<const Vec3> positions);

}  // namespace meniscus::pbd
