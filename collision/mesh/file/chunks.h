// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Checks how the parts of 3DS and FBX files are nested, before assimp reads them.
#pragma once

#include <string_view>

namespace meniscus::collision {

/// Throws FileDefect if a chunk of a 3DS file is longer than the one around it.
void check_three_ds(std::string_view bytes);

/// Throws FileDefect if a record of an FBX file, text or binary, is longer than the one around it, or if
/// records are nested too deeply.
void check_fbx(std::string_view bytes);

}  // namespace meniscus::collision
