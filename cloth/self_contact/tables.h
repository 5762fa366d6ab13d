// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What is known of a mesh before simulation: owned features, neighbours and fineness, for self-contact.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pbd/surface_tree/surface.h"

namespace meniscus::cloth {

/// Bits by triangle. Each vertex and each edge belongs to one of its triangles, so that no pair of features
/// is tested twice (Curtis, Tamstorf & Manocha 2008). Edge k runs from corner k to the next.
inline constexpr uint16_t owns_vertex = 1, owns_edge = 1 << 3, is_border = 1 << 6;

struct SelfContactTables {
  std::vector<uint16_t> features;  ///< by place in the tree
  /// By group of eight places, ascending: the groups that share a vertex with it, including itself.
  std::vector<uint32_t> neighbour_start, neighbours;
  std::vector<float> fineness;         ///< m, by piece: the least height of a triangle
  std::vector<uint32_t> vertex_piece;  ///< no_index for a vertex in no triangle, as in ropes
};

/// `triangles` in the order of the tree, with a = no_index at empty places.
SelfContactTables build_tables(std::span<const pbd::SurfaceTriangle> triangles,
                               std::span<const Vec3> positions, size_t pieces);

/// Those of all worlds of a batch, which follow one another, from those of one with so many pieces. The
/// fineness stays that of one.
SelfContactTables of_worlds(const SelfContactTables& one, uint32_t pieces, uint32_t worlds);

}  // namespace meniscus::cloth
