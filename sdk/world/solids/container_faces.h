// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <meniscus/defs.h>

#include <vector>

namespace meniscus {

/// What is there of a container's faces: rectangles around the openings, as boxes without depth, in the
/// container's frame.
struct FacePiece {
  Face face;
  Vec3 lower, upper;  ///< m; equal along the face's normal
};

/// Each face goes on for `beyond` (m) past its borders; openings may go there with it.
std::vector<FacePiece> container_faces(const ContainerGeometry& container, float beyond = 0);

}  // namespace meniscus
