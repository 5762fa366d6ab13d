// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What the contacts of cloth with cloth know of a mesh beforehand.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pbd/surface_tree/surface.h"

namespace meniscus::cloth {

/// Bits by triangle: each vertex and each edge belongs to one of its triangles, so that no two features meet
/// twice (Curtis, Tamstorf & Manocha 2008). Edge k runs from corner k to the next.
inline constexpr uint16_t owns_vertex = 1, owns_edge = 1 << 3, is_border = 1 << 6;

struct SelfContactTables {
  std::vector<uint16_t> features;  ///< by place in the tree
  /// By group of eight places, ascending: the groups that share a vertex with it, itself among them.
  std::vector<uint32_t> neighbour_start, neighbours;
  std::vector<float> fineness;        ///< m, by part: the least height of a triangle
  std::vector<uint32_t> vertex_part;  ///< no_index for what is of no triangle, as ropes are
};

/// `triangles` in the tree's order, a = no_index where nothing stands.
SelfContactTables build_tables(std::span<const pbd::SurfaceTriangle> triangles,
                               std::span<const Vec3> positions, size_t parts);

}  // namespace meniscus::cloth
