// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Loads meshes: reads, cleans and checks them.
#include "collision/mesh/mesh.h"

#include <meniscus/error.h>

#include <cmath>
#include <sstream>
#include <utility>

#include "collision/mesh/clean.h"
#include "collision/mesh/defects.h"
#include "collision/mesh/file/defect.h"
#include "collision/mesh/orient.h"
#include "collision/mesh/soup.h"
#include "pbd/math/vec.h"

namespace meniscus::collision {

namespace {

// Bounds of the size, m, for which products of six lengths are well within the range of float.
constexpr float smallest_size = 1e-6f, largest_size = 1e6f;

[[noreturn]] void refuse(ErrorCode code, const MeshSource& source, const std::string& why) {
  throw Error(code, source.name() + " " + why);
}

void check_scale(const MeshSource& source) {
  if (source.scale > 0 && std::isfinite(source.scale)) return;
  throw Error(ErrorCode::invalid_argument, "scale of " + source.name() + " is " +
                                               std::to_string(source.scale) +
                                               ": it must be a positive number of metres a file unit");
}

void check_size(const TriangleMesh& mesh, const MeshSource& source) {
  const Aabb box = bounds(mesh);
  const float size = max_component(box.upper - box.lower);
  if (size >= smallest_size && size <= largest_size) return;
  std::ostringstream why;
  why << "measures " << size << " m after scaling: from " << smallest_size << " to " << largest_size
      << " m are allowed";
  refuse(ErrorCode::mesh, source, why.str());
}

PaintedMesh read_triangles(const MeshSource& source) {
  check_scale(source);
  try {
    return source.in_memory() ? soup_in_memory(source) : read_soup(source);
  } catch (const FileDefect& defect) {
    refuse(ErrorCode::mesh, source, defect.what());
  }
}

CleanedMesh cleaned(const TriangleMesh& soup, const MeshSource& source) {
  CleanedMesh cleaned = clean_mesh_with_sources(soup);
  if (cleaned.mesh.triangles.empty()) refuse(ErrorCode::mesh, source, "has no triangle with an area");
  check_size(cleaned.mesh, source);
  orient_faces(cleaned.mesh);
  return cleaned;
}

// The texture of triangle `source` of the soup in the order of the corners of triangle t, which may have been
// turned around.
CornerTexture texture_in_order(const TriangleMesh& mesh, size_t t, const PaintedMesh& soup, size_t source) {
  CornerTexture texture;
  for (size_t k = 0; k < 3; ++k) {
    const Vec3 p = mesh.vertices[mesh.triangles[t][k]];
    const auto distance = [&](size_t c) {
      const Vec3 d = soup.mesh.vertices[soup.mesh.triangles[source][c]] - p;
      return dot(d, d);
    };
    size_t nearest = 0;
    for (size_t c = 1; c < 3; ++c) nearest = distance(c) < distance(nearest) ? c : nearest;
    texture[k] = soup.texture[source][nearest];
  }
  return texture;
}

// Throws for the first of the defects, if there is one. `faces` maps to the numbers in the file.
void refuse_defects(const std::vector<MeshDefect>& defects, const MeshSource& source, const std::string& what,
                    const std::vector<uint32_t>& faces, const std::string& remedy) {
  if (defects.empty()) return;
  const uint32_t face = faces[defects.front().face], other = faces[defects.front().other];
  std::string where = " at face " + std::to_string(face);
  if (other != face) where += " with face " + std::to_string(other);
  refuse(ErrorCode::mesh, source,
         "has " + what + where + " (" + std::to_string(defects.size()) + " in all): " + remedy);
}

}  // namespace

TriangleMesh load_soup(const MeshSource& source) {
  return read_triangles(source).mesh;
}

CleanedMesh load_cleaned_mesh(const MeshSource& source) {
  return cleaned(read_triangles(source).mesh, source);
}

TriangleMesh load_mesh(const MeshSource& source) {
  return load_cleaned_mesh(source).mesh;
}

TriangleMesh load_solid(const MeshSource& source) {
  CleanedMesh cleaned = load_cleaned_mesh(source);
  const MeshDefects defects = find_defects(cleaned.mesh);
  refuse_defects(defects.open_edges, source, "an open edge", cleaned.sources,
                 "a solid must be closed; \"repair\" closes it");
  refuse_defects(
      defects.non_manifold_edges, source, "a non-manifold edge", cleaned.sources,
      "two faces must meet at each edge of a solid, and show the same side; \"repair\" makes it so");
  refuse_defects(defects.self_intersections, source, "a self-intersection", cleaned.sources,
                 "the faces of a solid must not cross; \"repair\" drops what is inside");
  return std::move(cleaned.mesh);
}

PaintedMesh load_painted_mesh(const MeshSource& source) {
  const PaintedMesh soup = read_triangles(source);
  CleanedMesh clean = cleaned(soup.mesh, source);
  PaintedMesh painted{std::move(clean.mesh), {}};
  for (const uint32_t triangle : clean.sources) painted.colors.push_back(soup.colors[triangle]);
  for (size_t t = 0; !soup.texture.empty() && t < clean.sources.size(); ++t)
    painted.texture.push_back(texture_in_order(painted.mesh, t, soup, clean.sources[t]));
  return painted;
}

Aabb bounds(const TriangleMesh& mesh) {
  Aabb box{mesh.vertices.front(), mesh.vertices.front()};
  for (Vec3 v : mesh.vertices) box = {min(box.lower, v), max(box.upper, v)};
  return box;
}

double signed_volume(const TriangleMesh& mesh) {
  if (mesh.vertices.empty()) return 0;
  const Aabb box = bounds(mesh);
  const Vec3 centre = 0.5f * (box.lower + box.upper);
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.vertices[t[0]] - centre, b = mesh.vertices[t[1]] - centre,
               c = mesh.vertices[t[2]] - centre;
    sum += dot(a, cross(b, c));
  }
  return sum / 6;
}

}  // namespace meniscus::collision
