// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "pbd/math/vec.h"

namespace meniscus::render {

/// What colours stand for values.
enum class ColorMap {
  sequence,  ///< from little to much: dark blue, green, yellow
  balance,   ///< about zero: blue below, white, red above
};

/// Linear RGB at a place from 0 to 1; beyond, that of the end.
Vec3 color_at(ColorMap map, float place);

}  // namespace meniscus::render
