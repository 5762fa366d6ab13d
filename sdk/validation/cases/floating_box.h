// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A box that floats, the level of the water that it floats in, and bodies as dense as water.
#pragma once

#include <meniscus/world.h>

namespace meniscus::validation {

/// A box `height` spacings high on a square base half as wide again, in a tank with six spacings of water
/// around it and below it.
struct DraftCase {
  float density;  ///< kg/m³
  float spacing;  ///< m
  int height;     ///< spacings

  float box_height() const { return static_cast<float>(height) * spacing; }
  float base() const { return 1.5f * box_height(); }
  float draft() const { return density / 1000 * box_height(); }
  float tank_width() const { return base() + 12 * spacing; }
  float depth() const { return draft() + 6 * spacing; }
};

struct DraftMeasure {
  double surface_offset = 0;  ///< spacings: of the surface over the highest centres of a pool
  double error = 0;           ///< of the draft against Archimedes, over the height; mean of the last second
  double tilt = 0;            ///< degrees, at the end
  double speed = 0;           ///< m/s, at the end
  std::size_t outside = 0;
};

/// Ten seconds with xsph at 50 1/s, with the device and the solver of `base`.
DraftMeasure measure_draft(const WorldDef& base, const DraftCase& draft);

/// How far a body has risen, m, in the seconds after it was stopped in mid water. Before that the water has
/// half a second to settle about it.
double rise(const WorldDef& base, float size, const Geometry& geometry, float density, float seconds);

}  // namespace meniscus::validation
