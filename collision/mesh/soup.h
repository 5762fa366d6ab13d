// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The triangles of a mesh as they stand in its file or in memory.
#pragma once

#include <string>

#include "collision/mesh/mesh.h"

namespace meniscus::collision {

/// All triangles of a file, in metres, each with the colour of its material, before they are cleaned. Throws
/// FileDefect, Error(io) and Error(out_of_memory).
PaintedMesh read_soup(const MeshSource& source);
/// The same for triangles in memory. Throws Error(invalid_argument) where vertices or numbers are missing.
PaintedMesh soup_in_memory(const MeshSource& source);

/// The triangles of either, with errors that name it: Error(mesh) in place of FileDefect. Also throws
/// Error(invalid_argument) for a scale that is not positive.
TriangleMesh load_soup(const MeshSource& source);

}  // namespace meniscus::collision
