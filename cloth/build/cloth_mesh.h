// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The mesh of a piece of cloth at rest, with its checks.
#pragma once

#include <meniscus/types.h>

#include <array>
#include <cstdint>
#include <vector>

namespace meniscus::cloth {

/// A mesh of cloth at rest: a surface of triangles, with a border or closed, connected or in several parts.
struct ClothMesh {
  std::vector<Vec3> vertices;  ///< m: the shape without strain
  std::vector<std::array<uint32_t, 3>> triangles;

  /// By vertex (u, v): u runs along the warp, v along the weft. Only directions are taken from it, and
  /// lengths from the vertices. Texture coordinates therefore do as well as metres. May be empty. Then the
  /// warp of a triangle is the projection of the x axis on its plane. Where its normal lies within 8° of x,
  /// it is the projection of the z axis.
  std::vector<std::array<float, 2>> material;
};

/// Makes a flat sheet in the plane y = 0, centred at the origin and facing up. It has columns × rows
/// vertices, row by row: vertex (column, row) has the number row · columns + column. u runs along x and v
/// along z, both from 0. Diagonals change direction from row to row, so that the sheet's stiffness has no
/// handedness. Each inner vertex has six edges. The arguments must be in the ranges of SheetGeometry, which
/// World checks.
ClothMesh make_sheet(float width, float depth, uint32_t columns, uint32_t rows);

/// Throws Error(mesh) that names the first vertex, triangle or edge at fault. A mesh must have triangles.
/// Each vertex must be finite and used by a triangle, and each index in range. The height of a triangle must
/// be at least build_tuning::least_height of its longest edge. No two triangles may have the same three
/// vertices, and no edge more than two triangles. Material coordinates, if any, must be one per vertex,
/// finite, and give a direction in each triangle.
void check_mesh(const ClothMesh& mesh);

/// Orients triangles so that neighbours face the same side. Each connected part takes the side of its first
/// triangle. A one-sided part (a Möbius strip) keeps an edge across which its triangles disagree, which does
/// no harm.
void orient_triangles(ClothMesh& mesh);

/// Whether each edge has two triangles that agree on the side they face: the mesh then encloses a volume.
bool is_closed(const ClothMesh& mesh);

/// The number of each vertex's connected part. Parts are numbered by their first vertex.
std::vector<uint32_t> connected_parts(const ClothMesh& mesh);

}  // namespace meniscus::cloth
