// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Checks what assimp has read before anything works on it.
#include "collision/mesh/file/scene_check.h"

#include <assimp/scene.h>

#include <string>
#include <vector>

#include "collision/mesh/file/defect.h"
#include "collision/mesh/file/tuning.h"

namespace meniscus::collision {

namespace {

void check_face(const aiMesh& part, unsigned number) {
  const aiFace& face = part.mFaces[number];
  const std::string name = "has face " + std::to_string(number) + " of its part '" + part.mName.C_Str() + "'";
  if (!face.mIndices) throw FileDefect(name + " without corners");
  if (face.mNumIndices > mesh_file_tuning::most_corners) {
    throw FileDefect(name + " with " + std::to_string(face.mNumIndices) + " corners; at most " +
                     std::to_string(mesh_file_tuning::most_corners) + " are read");
  }
  for (unsigned c = 0; c < face.mNumIndices; ++c) {
    if (face.mIndices[c] >= part.mNumVertices) throw FileDefect(name + " with a vertex that it lacks");
  }
}

void check_part(const aiMesh* part) {
  if (!part || !part->mVertices || !part->mFaces) throw FileDefect("has a part without vertices or faces");
  for (unsigned f = 0; f < part->mNumFaces; ++f) check_face(*part, f);
}

void check_nodes(const aiScene& scene) {
  std::vector<const aiNode*> nodes{scene.mRootNode};
  for (size_t i = 0; i < nodes.size(); ++i) {
    const aiNode* node = nodes[i];
    if (!node) throw FileDefect("has a node that is missing");
    for (unsigned m = 0; m < node->mNumMeshes; ++m) {
      if (!node->mMeshes || node->mMeshes[m] >= scene.mNumMeshes)
        throw FileDefect("has a node with a part that is missing");
    }
    if (node->mNumChildren > 0 && !node->mChildren) throw FileDefect("has a node that is missing");
    nodes.insert(nodes.end(), node->mChildren, node->mChildren + node->mNumChildren);
  }
}

}  // namespace

void check_scene(const aiScene& scene) {
  if (!scene.mRootNode || scene.mNumMeshes == 0 || !scene.mMeshes) throw FileDefect("has no triangle");
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) check_part(scene.mMeshes[m]);
  check_nodes(scene);
}

}  // namespace meniscus::collision
