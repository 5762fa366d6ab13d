// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Loads meshes, with assimp.
#include "collision/mesh/mesh.h"

#include <meniscus/error.h>

#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>
#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>
#include <utility>

#include "collision/mesh/clean.h"
#include "collision/mesh/defects.h"
#include "collision/mesh/orient.h"
#include "pbd/math/vec.h"

namespace meniscus::collision {

namespace {

constexpr size_t most_vertices = std::numeric_limits<uint32_t>::max();
// Bounds of the size, m, for which products of six lengths are well within the range of float.
constexpr float smallest_size = 1e-6f, largest_size = 1e6f;

[[noreturn]] void refuse(ErrorCode code, const std::string& path, const std::string& why) {
  throw Error(code, "mesh file '" + path + "' " + why);
}

void check_arguments(const std::string& path, float scale) {
  if (!(scale > 0) || !std::isfinite(scale)) {
    throw Error(ErrorCode::invalid_argument, "scale of mesh file '" + path + "' is " + std::to_string(scale) +
                                                 ": it must be a positive number of metres a file unit");
  }
  std::error_code status;
  if (!std::filesystem::is_regular_file(path, status))
    refuse(ErrorCode::io, path, "is not there, or is not a file");
  if (std::filesystem::file_size(path, status) == 0) refuse(ErrorCode::mesh, path, "is empty");
}

// An FBX file states its unit in centimetres.
double metres_a_unit(const aiScene& scene) {
  double centimetres = 0;
  float single = 0;
  if (!scene.mMetaData) return 1;
  if (scene.mMetaData->Get("UnitScaleFactor", single)) centimetres = single;
  scene.mMetaData->Get("UnitScaleFactor", centimetres);
  return centimetres > 0 ? 0.01 * centimetres : 1;
}

// A mesh that several nodes refer to appears several times.
struct PlacedNode {
  const aiNode* node;
  aiMatrix4x4 to_world;
};

// Parents before children. Iterative and not recursive, because the file determines the depth.
std::vector<PlacedNode> placed_nodes(const aiScene& scene) {
  std::vector<PlacedNode> nodes;
  if (scene.mRootNode) nodes.push_back({scene.mRootNode, scene.mRootNode->mTransformation});
  for (size_t i = 0; i < nodes.size(); ++i) {
    const PlacedNode parent = nodes[i];
    for (unsigned c = 0; c < parent.node->mNumChildren; ++c) {
      const aiNode* child = parent.node->mChildren[c];
      nodes.push_back({child, parent.to_world * child->mTransformation});
    }
  }
  return nodes;
}

void append_vertices(TriangleMesh& soup, const aiMesh& part, const aiMatrix4x4& to_world, float scale,
                     const std::string& path) {
  if (soup.vertices.size() + part.mNumVertices > most_vertices) {
    refuse(ErrorCode::mesh, path, "has more than " + std::to_string(most_vertices) + " vertices");
  }
  for (unsigned v = 0; v < part.mNumVertices; ++v) {
    const aiVector3D p = to_world * part.mVertices[v];
    const Vec3 vertex = scale * Vec3{p.x, p.y, p.z};
    if (!is_finite(vertex)) {
      refuse(ErrorCode::mesh, path,
             "has a vertex that is not finite: number " + std::to_string(v) + " of its part '" +
                 part.mName.C_Str() + "', at scale " + std::to_string(scale));
    }
    soup.vertices.push_back(vertex);
  }
}

// The colour of a material; none for the default material that assimp adds to files without materials.
std::optional<Vec3> color_of(const aiMaterial& material) {
  aiString name;
  if (material.Get(AI_MATKEY_NAME, name) != aiReturn_SUCCESS || name.length == 0) return {};
  if (name == aiString(AI_DEFAULT_MATERIAL_NAME)) return {};
  aiColor4D color;
  if (material.Get(AI_MATKEY_BASE_COLOR, color) != aiReturn_SUCCESS &&
      material.Get(AI_MATKEY_COLOR_DIFFUSE, color) != aiReturn_SUCCESS)
    return {};
  const Vec3 rgb{color.r, color.g, color.b};
  if (!is_finite(rgb)) return {};
  return min(max(rgb, {0, 0, 0}), {1, 1, 1});
}

void append_part(PaintedMesh& all, const aiMesh& part, std::optional<Vec3> color, const aiMatrix4x4& to_world,
                 float scale, const std::string& path) {
  TriangleMesh& soup = all.mesh;
  const auto first = static_cast<uint32_t>(soup.vertices.size());
  append_vertices(soup, part, to_world, scale, path);
  const bool mirrored = to_world.Determinant() < 0;  // a reflection, which would invert the orientation
  for (unsigned f = 0; f < part.mNumFaces; ++f) {
    const aiFace& face = part.mFaces[f];
    if (face.mNumIndices != 3) continue;  // a point or a line
    std::array<uint32_t, 3> corners{face.mIndices[0], face.mIndices[1], face.mIndices[2]};
    for (uint32_t& corner : corners) {
      if (corner >= part.mNumVertices)
        refuse(ErrorCode::mesh, path, "has a face that names a vertex it lacks");
      corner += first;
    }
    if (mirrored) std::swap(corners[1], corners[2]);
    soup.triangles.push_back(corners);
    all.colors.push_back(color);
  }
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
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(path, aiProcess_Triangulate);
  if (!scene) refuse(ErrorCode::io, path, std::string("cannot be read: ") + importer.GetErrorString());
  const auto metres = static_cast<float>(scale * metres_a_unit(*scene));
  PaintedMesh soup;
  for (const PlacedNode& placed : placed_nodes(*scene)) {
    for (unsigned m = 0; m < placed.node->mNumMeshes; ++m) {
      const aiMesh& part = *scene->mMeshes[placed.node->mMeshes[m]];
      const bool has_material = part.mMaterialIndex < scene->mNumMaterials;
      append_part(soup, part, has_material ? color_of(*scene->mMaterials[part.mMaterialIndex]) : std::nullopt,
                  placed.to_world, metres, path);
    }
  }
  return soup;
}

CleanedMesh cleaned(const TriangleMesh& soup, const std::string& path) {
  CleanedMesh cleaned = clean_mesh_with_sources(soup);
  if (cleaned.mesh.triangles.empty()) refuse(ErrorCode::mesh, path, "has no triangle with an area");
  check_size(cleaned.mesh, path);
  orient_faces(cleaned.mesh);
  return cleaned;
}

CleanedMesh load(const std::string& path, float scale) {
  check_arguments(path, scale);
  return cleaned(read_triangles(path, scale).mesh, path);
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

TriangleMesh load_mesh(const std::string& path, float scale) {
  return load(path, scale).mesh;
}

TriangleMesh load_solid(const std::string& path, float scale) {
  CleanedMesh cleaned = load(path, scale);
  const MeshDefects defects = find_defects(cleaned.mesh);
  refuse_defects(defects.open_edges, path, "an open edge", cleaned.sources, "a solid must be closed");
  refuse_defects(defects.non_manifold_edges, path, "a non-manifold edge", cleaned.sources,
                 "two faces must meet at each edge of a solid, and show the same side");
  refuse_defects(defects.self_intersections, path, "a self-intersection", cleaned.sources,
                 "the faces of a solid must not cross");
  return std::move(cleaned.mesh);
}

PaintedMesh load_painted_mesh(const std::string& path, float scale) {
  check_arguments(path, scale);
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
