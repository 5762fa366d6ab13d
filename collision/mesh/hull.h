// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The convex hull of points, as a mesh.
#pragma once

#include <optional>
#include <span>

#include "collision/mesh/mesh.h"

namespace meniscus::collision {

/// The convex hull of points as a closed mesh. Throws Error(invalid_argument) where they span no volume.
TriangleMesh hull_mesh(std::span<const Vec3> points);

/// The same, or nothing where the points span no volume.
std::optional<TriangleMesh> find_hull(std::span<const Vec3> points);

}  // namespace meniscus::collision
