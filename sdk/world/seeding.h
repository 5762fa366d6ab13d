// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <meniscus/defs.h>

#include <span>
#include <vector>

#include "sdk/engine/engine.h"

namespace meniscus {

/// Points of the cubic lattice with this spacing inside the region, under its pose.
std::vector<Vec3> fill_region(const FluidVolumeDef& def, Engine& engine, float spacing);

/// `points` in disorder, as balls in a lattice would stand for ever: each is moved by up to a quarter of a
/// spacing along each axis, the same way every time. What is nearer than a spacing to a solid stays.
std::vector<Vec3> shaken(std::vector<Vec3> points, Engine& engine, float spacing,
                         const CollisionFilter& filter);

/// Those of `points` that lie further than half a spacing from every solid that the filter
/// collides with, and further than 0.7 spacings from
/// every point of `taken`.
std::vector<Vec3> safe_points(std::span<const Vec3> points, std::span<const Vec3> taken, Engine& engine,
                              float spacing, const CollisionFilter& filter);

}  // namespace meniscus
