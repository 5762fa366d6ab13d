// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Texture coordinates of cloth.
#pragma once

#include <string>
#include <vector>

#include "collision/mesh/mesh.h"
#include "sdk/world/cloth/cloth_table.h"

namespace meniscus {

/// The mesh of a file, with the texture of each triangle if the file has any.
struct TexturedCloth {
  std::string name;
  cloth::ClothMesh mesh;
  std::vector<collision::CornerTexture> texture;
  uint32_t welded = 0;  ///< vertices that were merged into others
};

/// Reads a file and merges vertices that are too near to one another. Throws what load_painted_mesh throws.
TexturedCloth read_cloth(const ClothFile& file, const FileReader& files);

/// The texture of cloth that was made of a file, whose triangles may have been turned around. Throws
/// Error(mesh) if the cloth was made of another file.
std::vector<TexturePoint> texture_on(const cloth::ClothMesh& cloth, const TexturedCloth& file);

/// One a corner of the triangles, or none: see World::cloth_texture. They follow from the rest shape. Those
/// of a file are read from it. Throws what read_cloth and texture_on throw.
std::vector<TexturePoint> texture_of(const ClothEntry& cloth, const FileReader& files);

}  // namespace meniscus
