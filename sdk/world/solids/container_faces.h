// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The faces of a container without its openings.
#pragma once

#include <meniscus/defs.h>

#include <vector>

namespace meniscus {

/// A part of a container's face: a rectangle beside the openings, as a box without depth, in the container's
/// frame.
struct FacePiece {
  Face face;
  Vec3 lower, upper;  ///< m; equal along the face's normal
};

/// Each face extends `beyond` (m) past its borders; openings may extend there as well.
std::vector<FacePiece> container_faces(const ContainerGeometry& container, float beyond = 0);

}  // namespace meniscus
