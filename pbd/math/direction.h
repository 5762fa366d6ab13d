// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "pbd/math/vec.h"

namespace meniscus::pbd {

inline constexpr float least_direction = 1e-6f, longest_direction = 1e18f;  ///< whose squares are of use, too

/// Whether a vector can be made a unit one.
inline bool is_direction(Vec3 v) {
  const float l = length(v);
  return l >= least_direction && l <= longest_direction;
}

}  // namespace meniscus::pbd
