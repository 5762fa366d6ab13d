// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Places the parts of an imported file, and joins them to one mesh.
#include "collision/mesh/soup.h"

#include <assimp/material.h>
#include <assimp/scene.h>
#include <meniscus/error.h>

#include <cmath>
#include <utility>

#include "collision/mesh/file/defect.h"
#include "collision/mesh/file/import.h"
#include "pbd/math/vec.h"

namespace meniscus::collision {

namespace {

// A file of a few bytes may place one part many times. This many take 1.6 GB.
constexpr size_t most_vertices = size_t{1} << 27;

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

void append_vertices(TriangleMesh& soup, const aiMesh& part, const aiMatrix4x4& to_world, float scale) {
  if (soup.vertices.size() + part.mNumVertices > most_vertices) {
    throw FileDefect("has more than " + std::to_string(most_vertices) + " vertices");
  }
  for (unsigned v = 0; v < part.mNumVertices; ++v) {
    const aiVector3D p = to_world * part.mVertices[v];
    const Vec3 vertex = scale * Vec3{p.x, p.y, p.z};
    if (!is_finite(vertex)) {
      throw FileDefect("has a vertex that is not finite: number " + std::to_string(v) + " of its part '" +
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

CornerTexture texture_of(const aiMesh& part, const aiFace& face, bool mirrored) {
  CornerTexture texture{};
  for (unsigned k = 0; part.HasTextureCoords(0) && k < 3; ++k) {
    const aiVector3D uv = part.mTextureCoords[0][face.mIndices[k]];
    if (std::isfinite(uv.x) && std::isfinite(uv.y)) texture[k] = {uv.x, uv.y};
  }
  if (mirrored) std::swap(texture[1], texture[2]);
  return texture;
}

void append_part(PaintedMesh& all, const aiMesh& part, std::optional<Vec3> color, const aiMatrix4x4& to_world,
                 float scale) {
  TriangleMesh& soup = all.mesh;
  const auto first = static_cast<uint32_t>(soup.vertices.size());
  append_vertices(soup, part, to_world, scale);
  const bool textured = part.HasTextureCoords(0);
  if (textured) all.texture.resize(soup.triangles.size());
  const bool mirrored = to_world.Determinant() < 0;  // a reflection, which would invert the orientation
  for (unsigned f = 0; f < part.mNumFaces; ++f) {
    const aiFace& face = part.mFaces[f];
    if (face.mNumIndices != 3) continue;  // a point or a line
    std::array<uint32_t, 3> corners{face.mIndices[0], face.mIndices[1], face.mIndices[2]};
    for (uint32_t& corner : corners) {
      if (corner >= part.mNumVertices) throw FileDefect("has a face that names a vertex it lacks");
      corner += first;
    }
    if (mirrored) std::swap(corners[1], corners[2]);
    soup.triangles.push_back(corners);
    all.colors.push_back(color);
    if (!all.texture.empty() || textured) all.texture.push_back(texture_of(part, face, mirrored));
  }
}

}  // namespace

PaintedMesh read_soup(const MeshSource& source) {
  const MeshImport import(source.file, source.read_file);
  const aiScene& scene = import.scene();
  const auto metres = static_cast<float>(source.scale * metres_a_unit(scene));
  PaintedMesh soup;
  for (const PlacedNode& placed : placed_nodes(scene)) {
    for (unsigned m = 0; m < placed.node->mNumMeshes; ++m) {
      const aiMesh& part = *scene.mMeshes[placed.node->mMeshes[m]];
      const bool has_material = part.mMaterialIndex < scene.mNumMaterials;
      append_part(soup, part, has_material ? color_of(*scene.mMaterials[part.mMaterialIndex]) : std::nullopt,
                  placed.to_world, metres);
    }
  }
  return soup;
}

PaintedMesh soup_in_memory(const MeshSource& source) {
  if (source.vertices.empty())
    throw Error(ErrorCode::invalid_argument,
                source.name() + ": vertices are missing, but triangles are there");
  if (source.triangles.size() % 3 != 0)
    throw Error(ErrorCode::invalid_argument, source.name() +
                                                 ": triangles must hold three numbers each, but there are " +
                                                 std::to_string(source.triangles.size()));
  if (source.vertices.size() > most_vertices)
    throw FileDefect("has more than " + std::to_string(most_vertices) + " vertices");
  PaintedMesh soup;
  soup.mesh.vertices.reserve(source.vertices.size());
  for (size_t v = 0; v < source.vertices.size(); ++v) {
    soup.mesh.vertices.push_back(source.scale * source.vertices[v]);
    if (!is_finite(soup.mesh.vertices.back())) {
      throw FileDefect("has a vertex that is not finite: number " + std::to_string(v) + ", at scale " +
                       std::to_string(source.scale));
    }
  }
  const std::span<const uint32_t> corners = source.triangles;
  for (size_t k = 0; k + 2 < corners.size(); k += 3) {
    for (size_t c = k; c < k + 3; ++c) {
      if (corners[c] >= source.vertices.size()) throw FileDefect("has a face that names a vertex it lacks");
    }
    soup.mesh.triangles.push_back({corners[k], corners[k + 1], corners[k + 2]});
  }
  soup.colors.resize(soup.mesh.triangles.size());
  return soup;
}

}  // namespace meniscus::collision
