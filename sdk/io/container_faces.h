// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <meniscus/defs.h>

#include <vector>

namespace meniscus::io {

/// What is there of a container's faces: rectangles around the openings, as boxes without depth, in the
/// container's frame.
struct FacePiece {
  Face face;
  Vec3 lower, upper;  ///< m; equal along the face's normal
};

std::vector<FacePiece> container_faces(const ContainerGeometry& container);

}  // namespace meniscus::io
