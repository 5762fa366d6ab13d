// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Start positions of particles.
#pragma once

#include <meniscus/defs.h>

#include <functional>
#include <span>
#include <vector>

#include "sdk/engine/engine.h"

namespace meniscus {

/// The points of the cubic lattice with this spacing inside the region, under its pose. The region's ends are
/// rounded by `rounding` m, as arguments are far from zero.
std::vector<Vec3> fill_region(const FluidVolumeDef& def, Engine& engine, float spacing, float rounding,
                              const FileReader& files);

/// Points without order in the region, under its pose, that are relaxed beside solids and the points of
/// `taken`. `keep` removes points where cloth is.
std::vector<Vec3> fill_in_disorder(const FluidVolumeDef& def, Engine& engine, float spacing,
                                   const FileReader& files, std::span<const Vec3> taken,
                                   const CollisionFilter& filter,
                                   const std::function<void(std::vector<Vec3>&)>& keep);

/// Disturbs `points`, because balls in a regular lattice would stand for ever. Each point moves by up to a
/// quarter of a spacing along each axis, the same way every time. Points nearer than a spacing to a solid
/// stay.
std::vector<Vec3> shaken(std::vector<Vec3> points, Engine& engine, float spacing,
                         const CollisionFilter& filter);

/// The points that lie further than half a spacing from every solid with which the filter collides. They are
/// also further than 0.7 spacings from every point of `taken`. Solids may have moved by `rounding` m, as
/// arguments far from zero do.
std::vector<Vec3> safe_points(std::span<const Vec3> points, std::span<const Vec3> taken, Engine& engine,
                              float spacing, float rounding, const CollisionFilter& filter);

}  // namespace meniscus
