// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Meshes of numbered files that have the same triangles, one a frame.
#pragma once

#include <string>
#include <vector>

#include "collision/mesh/mesh.h"

namespace meniscus::collision {

struct MeshSequence {
  TriangleMesh mesh;                      ///< of the first file, clean
  std::vector<std::vector<Vec3>> frames;  ///< m: its vertices in each file
};

/// The path with the number in place of %d, or of %04d with leading zeros. Throws Error(invalid_argument)
/// unless the pattern has exactly one of these.
std::string numbered_path(const std::string& pattern, int number);

/// Reads the files with these numbers. The first is cleaned as by load_mesh, and all others have its vertices
/// and triangles. Throws as load_mesh. Also throws Error(mesh) if a file has not as many vertices or other
/// triangles than the first, or if vertices that were merged in the first are apart in it.
MeshSequence load_sequence(const std::string& pattern, int first, int last, float scale,
                           const FileReader& files);

}  // namespace meniscus::collision
