// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Where rays, balls and boxes of queries meet particles, triangles of cloth and segments of ropes.
#pragma once

#include <meniscus/types.h>

#include <optional>

#include "pbd/math/vec.h"

namespace meniscus::queries {

/// The first intersection of a ray with a ball, as a fraction of the ray; nothing if the ray starts inside.
std::optional<float> meet_ball(Vec3 from, Vec3 ray, Vec3 centre, float radius);

/// With a triangle, from either side (Möller & Trumbore 1997).
std::optional<float> meet_triangle(Vec3 from, Vec3 ray, Vec3 a, Vec3 b, Vec3 c);

/// With the round segment from a to b; nothing if the ray starts inside.
std::optional<float> meet_segment(Vec3 from, Vec3 ray, Vec3 a, Vec3 b, float radius);

/// The point of the segment from a to b that is nearest to p.
Vec3 nearest_on_segment(Vec3 p, Vec3 a, Vec3 b);

/// Whether a triangle overlaps the box of these half extents about the origin, by the separating axes
/// (Akenine-Möller 2001).
bool overlaps_box(Vec3 half, Vec3 a, Vec3 b, Vec3 c);

/// Whether the segment from a to b comes within a distance of that box.
bool comes_near_box(Vec3 half, Vec3 a, Vec3 b, float distance);

}  // namespace meniscus::queries
