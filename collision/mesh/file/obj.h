// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Checks OBJ files before assimp reads them.
#pragma once

#include <string_view>

namespace meniscus::collision {

/// Throws FileDefect if an OBJ file with these bytes is not text, has a vertex without three numbers, has a
/// face that names what the file lacks, or has more parts than assimp reads in reasonable time.
void check_obj(std::string_view bytes);

}  // namespace meniscus::collision
