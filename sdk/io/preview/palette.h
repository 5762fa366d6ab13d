// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Default colours of objects by their place in the scene, linear RGB.
#pragma once

#include <cstddef>
#include <iterator>

#include "pbd/math/vec.h"

namespace meniscus::io {

inline Vec3 shape_color(std::size_t i) {
  constexpr Vec3 colors[] = {
      {0.58f, 0.55f, 0.50f}, {0.62f, 0.27f, 0.11f}, {0.30f, 0.38f, 0.20f}, {0.42f, 0.30f, 0.42f}};
  return colors[i % std::size(colors)];
}

/// They differ from each other, from those of shapes, and from water.
inline Vec3 body_color(std::size_t i) {
  constexpr Vec3 colors[] = {{0.52f, 0.29f, 0.10f}, {0.80f, 0.52f, 0.08f}, {0.55f, 0.09f, 0.06f},
                             {0.70f, 0.60f, 0.42f}, {0.20f, 0.34f, 0.10f}, {0.75f, 0.30f, 0.06f},
                             {0.33f, 0.14f, 0.30f}, {0.30f, 0.17f, 0.08f}, {0.62f, 0.65f, 0.14f},
                             {0.62f, 0.24f, 0.26f}};
  return colors[i % std::size(colors)];
}

}  // namespace meniscus::io
