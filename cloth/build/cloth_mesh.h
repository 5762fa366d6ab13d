// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <meniscus/types.h>

#include <array>
#include <cstdint>
#include <vector>

namespace meniscus::cloth {

/// A piece of cloth at rest: a surface of triangles, with a border or closed, in one piece or in several.
struct ClothMesh {
  std::vector<Vec3> vertices;  ///< m: the shape that is free of strain
  std::vector<std::array<uint32_t, 3>> triangles;

  /// Of each vertex (u, v): u runs along the warp, v along the weft. Directions alone are taken from it,
  /// lengths from the vertices, so that the coordinates of a picture do as well as metres. May be empty: then
  /// the warp of a triangle is the projection of the x axis on to it, or of the z axis where the triangle
  /// faces x (its normal within 8° of it).
  std::vector<std::array<float, 2>> material;
};

/// A flat sheet in the plane y = 0, centred at the origin and facing up. columns × rows vertices, row by row:
/// vertex (column, row) has the number row · columns + column. u runs along x, v along z, both from 0.
/// Diagonals change direction from row to row, so that the sheet's stiffness has no handedness, and each
/// inner vertex has six edges. Throws Error(invalid_argument) for a width or depth that is not positive, or
/// fewer than two columns or rows, or more than 2²⁷ vertices.
ClothMesh make_sheet(float width, float depth, uint32_t columns, uint32_t rows);

/// Throws Error(mesh) that names the first vertex, triangle or edge at fault: no triangles, a vertex that is
/// not finite or that no triangle uses, an index out of range, a triangle without area (height below 10⁻⁶ of
/// the longest edge), two triangles on the same three vertices, an edge with more than two triangles,
/// material coordinates that are not one a vertex, not finite, or without a direction in some triangle.
void check_mesh(const ClothMesh& mesh);

/// Turns triangles so that neighbours show the same side: each connected part the side of its first triangle.
/// A part that has but one side (Möbius' strip) keeps an edge across which its triangles disagree; cloth does
/// not mind.
void orient_triangles(ClothMesh& mesh);

/// Every edge has two triangles, and they agree on the side that they show: the mesh encloses a volume.
bool is_closed(const ClothMesh& mesh);

/// Of each vertex the number of its connected part; parts are numbered by their first vertex.
std::vector<uint32_t> connected_parts(const ClothMesh& mesh);

}  // namespace meniscus::cloth
