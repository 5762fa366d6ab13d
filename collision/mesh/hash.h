// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A hash that identifies a mesh by its contents.
#pragma once

#include "collision/mesh/mesh.h"

namespace meniscus::collision {

/// Identifies a mesh: sizes, and two independent 64-bit hashes of the contents.
struct MeshHash {
  size_t vertices = 0, triangles = 0;
  uint64_t first = 0, second = 0;

  bool operator==(const MeshHash&) const = default;
};

MeshHash hash_of(const TriangleMesh& mesh);

}  // namespace meniscus::collision
