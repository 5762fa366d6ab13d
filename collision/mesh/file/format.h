// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The formats of mesh files that are read.
#pragma once

#include <string>

namespace meniscus::collision {

enum class MeshFormat { obj, ply, stl, gltf, fbx, dae, three_ds };

/// The format by the file's extension, in small or capital letters. Throws FileDefect for any other
/// extension, and lists the formats.
MeshFormat format_of(const std::string& path);

/// The extension of a path in small letters, without the dot.
std::string extension_of(const std::string& path);

}  // namespace meniscus::collision
