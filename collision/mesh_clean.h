// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "collision/mesh.h"

namespace meniscus::collision {

/// Welds vertices nearer than a millionth of the box's diagonal, then drops triangles without area, triangles
/// that are there twice, and vertices that no triangle uses. What is left keeps its order. Vertices must be
/// finite.
TriangleMesh clean_mesh(const TriangleMesh& mesh);

}  // namespace meniscus::collision
