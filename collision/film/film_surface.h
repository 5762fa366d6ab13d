// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The surfaces of bodies as triangles that are fine enough for films.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "collision/mesh/mesh.h"

namespace meniscus::collision {

/// The surfaces of round shapes around the y axis and of boxes, as coarse as their form allows. Circles have
/// edges of about this length, m.
TriangleMesh box_surface_mesh(Vec3 half);
TriangleMesh capsule_surface_mesh(float radius, float half_height, float edge);
TriangleMesh cylinder_surface_mesh(float radius, float half_height, float edge);

/// The same surface in triangles with edges of at most `edge` (m), or longer ones if it would have more than
/// film_tuning::most_triangles. Vertices of a finer mesh that are near one another become one.
TriangleMesh film_mesh(TriangleMesh mesh, float edge);

/// The surface of one shape that a body carries.
struct FilmPart {
  uint32_t shape = 0;  ///< its number among all shapes
  uint32_t body = 0;
  Pose pose{};  ///< in the body's principal frame
  std::shared_ptr<const TriangleMesh> mesh;
};

/// A triangle of a body's surface.
struct FilmTriangle {
  uint32_t corner[3];
  uint32_t body, shape;
  Vec3 centre;  ///< m, in the body's principal frame
  Vec3 area;    ///< m², along the outward normal
};

/// A triangle as one of its corners sees it: the two other corners, and what couples them to this one in
/// ∫ ∇u·∇v over the triangle, for linear elements. That is half the cotangent of the opposite angle.
struct FilmCorner {
  uint32_t triangle;
  uint32_t other[2];
  float coupling[2];
};

/// The vertices and the triangles of a body.
struct FilmRange {
  uint32_t first_vertex = 0, vertex_end = 0, first_triangle = 0, triangle_end = 0;
  /// Between two bodies the one of lower rank has the film: the one with the smaller surface.
  uint32_t rank = 0;
};

/// All surfaces of a world.
struct FilmSurfaces {
  std::vector<Vec3> vertices;  ///< m, in their bodies' principal frames
  std::vector<FilmTriangle> triangles;
  std::vector<uint32_t> first_corner;  ///< by vertex, and the end
  std::vector<FilmCorner> corners;     ///< grouped by vertex
  std::vector<FilmRange> bodies;       ///< by body
};

/// The parts of a body must follow one another.
FilmSurfaces join_film_parts(std::span<const FilmPart> parts, uint32_t bodies);

}  // namespace meniscus::collision
