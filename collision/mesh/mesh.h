// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Triangle meshes: loading, bounds and volume.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "collision/mesh/source.h"

namespace meniscus::collision {

/// A triangle mesh. Triangles are counter-clockwise as seen from outside. It may have holes.
struct TriangleMesh {
  std::vector<Vec3> vertices;  ///< m
  std::vector<std::array<uint32_t, 3>> triangles;
};

/// Reads a mesh and makes a clean one of all its contents (see clean_mesh). Formats of files are OBJ, PLY,
/// STL, glTF, FBX, Collada and 3DS, by their extensions (see file/format.h). Node transforms are applied,
/// polygons are triangulated, points and lines are skipped, and faces are turned outwards (see orient_faces).
/// The mesh may have holes. `scale` is in metres per file unit. For a format that states its unit, as FBX
/// does, it is in metres per metre. Axes stay as in the file. Throws Error(io) for a file that is missing or
/// cannot be read. Throws Error(mesh) for one that is not valid or not of these formats, without a triangle,
/// with a vertex that is not finite, or of a size outside 1e-6 to 1e6 m. Throws Error(invalid_argument) for a
/// scale that is not positive. Triangles in memory are treated likewise.
TriangleMesh load_mesh(const MeshSource& source);
inline TriangleMesh load_mesh(const std::string& path, float scale = 1.0f) {
  return load_mesh(MeshSource(path, scale));
}

/// The same for a mesh that must bound a solid. Also throws Error(mesh) where it does not (see find_defects).
/// The message names the defect and a face. Faces are numbered from 0 in the order of the file, after
/// triangulation and over all parts.
TriangleMesh load_solid(const MeshSource& source);
inline TriangleMesh load_solid(const std::string& path, float scale = 1.0f) {
  return load_solid(MeshSource(path, scale));
}

/// Texture coordinates (u, v) of the corners of a triangle.
using CornerTexture = std::array<std::array<float, 2>, 3>;

/// A mesh with the colour of each triangle's material, linear RGB, 0 to 1, where the file has one.
struct PaintedMesh {
  TriangleMesh mesh;
  std::vector<std::optional<Vec3>> colors;
  std::vector<CornerTexture> texture{};  ///< by triangle, 0 where a part has none; empty if no part has any
};
/// Like load_mesh. Pictures of textures are ignored.
PaintedMesh load_painted_mesh(const MeshSource& source);

/// The box around the vertices; there must be at least one.
Aabb bounds(const TriangleMesh& mesh);

/// m³, positive where the triangles face outwards. Each hole counts as closed by a cone to the centre of the
/// box.
double signed_volume(const TriangleMesh& mesh);

}  // namespace meniscus::collision
