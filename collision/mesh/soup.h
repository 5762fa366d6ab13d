// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The triangles of a mesh file as they stand in it.
#pragma once

#include <string>

#include "collision/mesh/mesh.h"

namespace meniscus::collision {

/// All triangles of a file, in metres, each with the colour of its material, before they are cleaned. Throws
/// FileDefect, Error(io) and Error(out_of_memory).
PaintedMesh read_soup(const std::string& path, float scale);

}  // namespace meniscus::collision
