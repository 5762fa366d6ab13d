// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Colour maps for measured values.
#pragma once

#include "pbd/math/vec.h"

namespace meniscus::render {

/// The meaning of colours.
enum class ColorMap {
  sequence,  ///< from small to large: dark blue, green, yellow
  balance,   ///< about zero: blue below, white, red above
};

/// Linear RGB at a place from 0 to 1; beyond these, the colour of the end.
Vec3 color_at(ColorMap map, float place);

}  // namespace meniscus::render
