// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Stateless random numbers: hashes of counters, the same on all devices.
#pragma once

#include "pbd/math/vec.h"

namespace meniscus::pbd {

/// Three random numbers from 0 to 1 for three counters (pcg3d, Jarzynski & Olano 2020).
MENISCUS_HD inline Vec3 random_numbers(uint32_t x, uint32_t y, uint32_t z) {
  x = x * 1664525u + 1013904223u;
  y = y * 1664525u + 1013904223u;
  z = z * 1664525u + 1013904223u;
  for (int round = 0; round < 2; ++round) {
    x += y * z;
    y += z * x;
    z += x * y;
    if (round == 1) break;
    x ^= x >> 16;
    y ^= y >> 16;
    z ^= z >> 16;
  }
  constexpr float unit = 1.0f / (1 << 24);
  return {unit * static_cast<float>(x >> 8), unit * static_cast<float>(y >> 8),
          unit * static_cast<float>(z >> 8)};
}

}  // namespace meniscus::pbd
