// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <meniscus/defs.h>

#include <array>
#include <optional>
#include <vector>

namespace meniscus::io {

/// In the frame of its solid; its corners turn counter-clockwise as seen from outside.
struct SolidTriangle {
  std::array<Vec3, 3> corners;  ///< m
  std::array<Vec3, 3> normals;  ///< unit, out of the solid; smooth where the solid is round
  std::optional<Vec3> color{};  ///< linear RGB, of a mesh whose file has materials
};

/// The surface of a solid. A container is its walls, seen from inside, without the openings; a plane, which
/// has no end, has none. Parts of a compound are taken as they are, also where they overlap. May throw what
/// load_painted_mesh and hull_mesh throw.
std::vector<SolidTriangle> solid_triangles(const Geometry& geometry);

}  // namespace meniscus::io
