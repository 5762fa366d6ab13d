// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <meniscus/types.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace meniscus::collision {

/// A surface of triangles that turn counter-clockwise as seen from outside. It may have holes.
struct TriangleMesh {
  std::vector<Vec3> vertices;  ///< m
  std::vector<std::array<uint32_t, 3>> triangles;
};

/// Reads any file that assimp knows and makes one clean mesh of all that is in it (see clean_mesh): node
/// transforms are applied, polygons triangulated, points and lines passed over, faces turned outwards (see
/// orient_faces). It may have holes. `scale`: metres a file unit; where the file says how long its unit is,
/// as FBX does, metres for each metre. Axes are left as the file has them. Throws Error(io) for a file that
/// is missing or cannot be understood, Error(mesh) for one without a triangle, with a vertex that is not
/// finite or of a size beyond 1e-6 to 1e6 m, Error(invalid_argument) for a scale that is not positive.
TriangleMesh load_mesh(const std::string& path, float scale = 1.0f);

/// The same for a body whose volume counts. Throws also Error(mesh) where the faces do not bound a solid (see
/// find_defects); the message names the defect and a face, by its place in the file, from 0, after
/// triangulation and over all parts.
TriangleMesh load_solid(const std::string& path, float scale = 1.0f);

/// A mesh, and of each triangle the colour of its material, linear RGB, 0 to 1, where the file has one.
struct PaintedMesh {
  TriangleMesh mesh;
  std::vector<std::optional<Vec3>> colors;
};
/// As load_mesh. Textures are passed over.
PaintedMesh load_painted_mesh(const std::string& path, float scale = 1.0f);

/// The box around the vertices, of which there must be one.
Aabb bounds(const TriangleMesh& mesh);

/// m³, positive where the triangles face outwards. Of a mesh with holes: as if each was closed by a cone to
/// the centre of the box.
double signed_volume(const TriangleMesh& mesh);

}  // namespace meniscus::collision
