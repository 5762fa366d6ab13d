// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What a world with periodic axes takes, and what it refuses.
#pragma once

#include <meniscus/defs.h>

#include <span>

#include "pbd/math/periodic_axes.h"

namespace meniscus {

pbd::PeriodicAxes periodic_axes(const PeriodicDef& def);

namespace check {

/// Throws Error(invalid_argument) if the world has a periodic axis: it has no room for this kind of thing.
void no_periodic_axes(const WorldDef& world, const char* kind);

/// Throws Error(invalid_argument) if a point is not between the ends of the periodic axes.
void between_seams(const pbd::PeriodicAxes& axes, std::span<const Vec3> points, const char* what);

}  // namespace check

}  // namespace meniscus
