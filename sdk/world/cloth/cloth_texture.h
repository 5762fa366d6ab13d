// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Texture coordinates of cloth.
#pragma once

#include <vector>

#include "sdk/world/cloth/cloth_table.h"

namespace meniscus {

/// One a corner of the triangles, or none: see World::cloth_texture. They follow from the rest shape. Those
/// of a file are read from it. Throws what load_painted_mesh throws, and Error(mesh) if the file has changed.
std::vector<TexturePoint> texture_of(const ClothEntry& cloth, const FileReader& files);

}  // namespace meniscus
