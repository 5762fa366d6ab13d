// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "collision/mesh/mesh.h"

namespace meniscus::collision {

/// What tells meshes apart: sizes, and two 64-bit hashes of the contents that have nothing in common.
struct MeshHash {
  size_t vertices = 0, triangles = 0;
  uint64_t first = 0, second = 0;

  bool operator==(const MeshHash&) const = default;
};

MeshHash hash_of(const TriangleMesh& mesh);

}  // namespace meniscus::collision
