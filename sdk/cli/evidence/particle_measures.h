// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// How particles are spread, and how they rotate: measured on the host, from positions and velocities.
#pragma once

#include <meniscus/types.h>

#include <span>
#include <vector>

namespace meniscus::cli {

/// m, from each particle to the nearest other one; `reach` where none is nearer.
std::vector<float> nearest_distances(std::span<const Vec3> positions, float reach);

/// 1/s, the curl of the velocity at each particle, from the neighbours within `reach`:
/// ω_i = 3 Σ w x_ij × v_ij / Σ w |x_ij|² with w = (1 − |x_ij|/reach)². Exact for a rigid rotation where the
/// neighbours have no direction; approximate at a surface. 0 with fewer than 8 neighbours.
std::vector<Vec3> vorticity_of(std::span<const Vec3> positions, std::span<const Vec3> velocities,
                               float reach);

}  // namespace meniscus::cli
