// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reads STL files, binary and ASCII.
#pragma once

#include <string_view>

#include "collision/mesh/file/polygons.h"

namespace meniscus::collision {

/// The triangles of an STL file with these bytes. Throws FileDefect. A binary file has exactly the size that
/// its number of triangles needs.
Polygons read_stl(std::string_view bytes);

}  // namespace meniscus::collision
