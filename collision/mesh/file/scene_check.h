// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Checks what assimp has read before anything works on it.
#pragma once

struct aiScene;

namespace meniscus::collision {

/// Throws FileDefect if a node, a part or an array is missing, if a face names a vertex that its part lacks,
/// or has more corners than are triangulated in reasonable time.
void check_scene(const aiScene& scene);

}  // namespace meniscus::collision
