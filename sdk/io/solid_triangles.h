// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Triangles of solids, for pictures and files.
#pragma once

#include <meniscus/defs.h>

#include <array>
#include <optional>
#include <vector>

namespace meniscus::io {

/// A triangle in the frame of its solid. Its corners are counter-clockwise as seen from outside.
struct SolidTriangle {
  std::array<Vec3, 3> corners;  ///< m
  std::array<Vec3, 3> normals;  ///< unit, out of the solid; smooth on round solids
  std::optional<Vec3> color{};  ///< linear RGB, of a mesh whose file has materials
};

/// The surface of a solid. A container consists of its walls, seen from inside, without the openings. A plane
/// is infinite and has no triangles. Parts of a compound are used as they are, even if they overlap. May
/// throw what load_painted_mesh and hull_mesh throw.
std::vector<SolidTriangle> solid_triangles(const Geometry& geometry);

}  // namespace meniscus::io
