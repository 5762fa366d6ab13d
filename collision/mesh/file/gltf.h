// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Checks glTF files before assimp reads them.
#pragma once

#include <string_view>

namespace meniscus::collision {

/// Throws FileDefect if a glTF file with these bytes, text or binary, has chunks that are longer than the
/// file, is no JSON, or asks for more than the file has.
void check_gltf(std::string_view bytes);

}  // namespace meniscus::collision
