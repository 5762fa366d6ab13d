// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Ropes and strips of cloth that hang between two points, and a chain that swings.
#pragma once

#include <meniscus/world.h>

#include <span>
#include <vector>

#include "sdk/validation/case.h"

namespace meniscus::validation {

/// Of a chain of this length between two points 1 m apart. Its parameter a is from sinh(1/2a) = L/2a: the sag
/// is a (cosh(1/2a) − 1), and at its ends it is atan sinh(1/2a) steep.
struct Catenary {
  float length = 0;     ///< m
  float sag = 0;        ///< m
  float end_angle = 0;  ///< degrees
};

/// What theory says for a length.
Catenary exact_catenary(float length);
/// A rope after a minute without air.
Catenary hang_rope(const WorldDef& base, float length, int substeps);
/// A strip of cloth that sinks into its shape through dense air.
Catenary hang_strip(const WorldDef& base, float length);

/// How the end of a rope of 1 m that hangs from a point swings in its first mode: m over s.
Curve swing_chain(const WorldDef& base, int segments);

}  // namespace meniscus::validation
