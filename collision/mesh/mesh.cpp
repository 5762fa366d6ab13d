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

[[noreturn]] void refuse(ErrorCode code, const std::string& path, const std::string& why) {
  throw Error(code, "mesh file '" + path + "' " + why);
}

void check_scale(const std::string& path, float scale) {
  if (scale > 0 && std::isfinite(scale)) return;
  throw Error(ErrorCode::invalid_argument, "scale of mesh file '" + path + "' is " + std::to_string(scale) +
                                               ": it must be a positive number of metres a file unit");
}

void check_size(const TriangleMesh& mesh, const std::string& path) {
  const Aabb box = bounds(mesh);
  const float size = max_component(box.upper - box.lower);
  if (size >= smallest_size && size <= largest_size) return;
  std::ostringstream why;
  why << "measures " << size << " m after scaling: from " << smallest_size << " to " << largest_size
      << " m are allowed";
  refuse(ErrorCode::mesh, path, why.str());
}

PaintedMesh read_triangles(const std::string& path, float scale) {
  check_scale(path, scale);
  try {
    return read_soup(path, scale);
  } catch (const FileDefect& defect) {
    refuse(ErrorCode::mesh, path, defect.what());
  }
}

CleanedMesh cleaned(const TriangleMesh& soup, const std::string& path) {
  CleanedMesh cleaned = clean_mesh_with_sources(soup);
  if (cleaned.mesh.triangles.empty()) refuse(ErrorCode::mesh, path, "has no triangle with an area");
  check_size(cleaned.mesh, path);
  orient_faces(cleaned.mesh);
  return cleaned;
}

// Throws for the first of the defects, if there is one. `faces` maps to the numbers in the file.
void refuse_defects(const std::vector<MeshDefect>& defects, const std::string& path, const std::string& what,
                    const std::vector<uint32_t>& faces, const std::string& remedy) {
  if (defects.empty()) return;
  const uint32_t face = faces[defects.front().face], other = faces[defects.front().other];
  std::string where = " at face " + std::to_string(face);
  if (other != face) where += " with face " + std::to_string(other);
  refuse(ErrorCode::mesh, path,
         "has " + what + where + " (" + std::to_string(defects.size()) + " in all): " + remedy);
}

}  // namespace

CleanedMesh load_cleaned_mesh(const std::string& path, float scale) {
  return cleaned(read_triangles(path, scale).mesh, path);
}

TriangleMesh load_mesh(const std::string& path, float scale) {
  return load_cleaned_mesh(path, scale).mesh;
}

TriangleMesh load_solid(const std::string& path, float scale) {
  CleanedMesh cleaned = load_cleaned_mesh(path, scale);
  const MeshDefects defects = find_defects(cleaned.mesh);
  refuse_defects(defects.open_edges, path, "an open edge", cleaned.sources,
                 "a solid must be closed; \"repair\" closes it");
  refuse_defects(
      defects.non_manifold_edges, path, "a non-manifold edge", cleaned.sources,
      "two faces must meet at each edge of a solid, and show the same side; \"repair\" makes it so");
  refuse_defects(defects.self_intersections, path, "a self-intersection", cleaned.sources,
                 "the faces of a solid must not cross; \"repair\" drops what is inside");
  return std::move(cleaned.mesh);
}

PaintedMesh load_painted_mesh(const std::string& path, float scale) {
  const PaintedMesh soup = read_triangles(path, scale);
  CleanedMesh clean = cleaned(soup.mesh, path);
  PaintedMesh painted{std::move(clean.mesh), {}};
  for (const uint32_t source : clean.sources) painted.colors.push_back(soup.colors[source]);
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
