// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Strips of cloth that bend under their own weight, and sheets on slopes.
#pragma once

#include <meniscus/world.h>

namespace meniscus::validation {

/// m: how far the tip of a strip of cloth drops, under the load B = w L³/D. It is 1 m long beyond its clamp,
/// which is in the middle of the one column of squares that is held. It is wide enough not to turn up its
/// edges (a narrow one bends across as well), and without damping, which slows the convergence of bending.
/// Substeps go with the square of a square's side: as α̃/w does.
double strip_drop(const WorldDef& base, float load, int squares, BendingModel model);

/// m: how far a sheet slides down a slope in the second from half a second on.
double slide(const WorldDef& base, float friction, float degrees);
/// m: the same by Coulomb's law.
double exact_slide(float friction, float degrees);

}  // namespace meniscus::validation
