// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Which vectors can be normalised.
#pragma once

#include "pbd/math/vec.h"

namespace meniscus::pbd {

inline constexpr float least_direction = 1e-6f,
                       longest_direction = 1e18f;  ///< whose squares are representable, too

/// Whether a vector can be normalised.
inline bool is_direction(Vec3 v) {
  const float l = length(v);
  return l >= least_direction && l <= longest_direction;
}

}  // namespace meniscus::pbd
