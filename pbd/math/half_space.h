// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The fraction of a kernel's support that lies in a solid at signed distance d. The half-space has a closed
// form. Its first-order change over a curved surface follows from integrating the surface's sag ρ²H/2 over
// the plane at distance d.
#pragma once

#include "pbd/math/vec.h"

namespace meniscus::pbd {

/// ∫ W_poly6 over a half-space at distance d: 1 deep inside, ½ on the surface, 0 from h on. x = d / h.
MENISCUS_HD inline float half_space_density(float x) {
  x = clamp(x, -1.0f, 1.0f);
  const float x2 = x * x;
  const float f = x * (1 + x2 * (-4.0f / 3 + x2 * (6.0f / 5 + x2 * (-4.0f / 7 + x2 * (1.0f / 9)))));
  return 0.5f - 315.0f / 256 * f;
}

/// Change of half_space_density with the mean curvature H: −(315/2560) hH (1 − x²)⁵.
MENISCUS_HD inline float half_space_density(float x, float curvature_h) {
  const float a = max(0.0f, 1 - x * x), a2 = a * a;
  return clamp(half_space_density(x) - 315.0f / 2560 * curvature_h * a2 * a2 * a, 0.0f, 1.0f);
}

}  // namespace meniscus::pbd
