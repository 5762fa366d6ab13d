// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reads PLY files, binary and ASCII.
#pragma once

#include <string_view>

#include "collision/mesh/file/polygons.h"

namespace meniscus::collision {

/// The vertices and faces of a PLY file with these bytes. Other elements and properties are passed over.
/// Throws FileDefect, before it takes memory for what the file promises and does not have.
Polygons read_ply(std::string_view bytes);

}  // namespace meniscus::collision
