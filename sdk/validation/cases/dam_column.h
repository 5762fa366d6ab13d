// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A column of water twice as high as it is wide collapses: its front on the floor and its height at the wall.
#pragma once

#include "sdk/validation/case.h"

namespace meniscus::validation {

/// The column is `width` wide, and the channel 0.4 widths.
struct DamColumn {
  WorldDef world;      ///< with its spacing
  float width = 1;     ///< m, a
  float length = 6;    ///< of the channel, in widths
  float end_time = 2;  ///< s, for a width of 1 m
};

/// The world of a column that is `across` spacings wide. A frame has a substep for each five of them, and at
/// least the usual four: the front then moves by half a spacing or less in a substep. In longer ones columns
/// of more than 80 layers throw up water along the wall. At full resolution, with hundreds of layers, the
/// density is solved on the pressure grid first.
WorldDef column_world(const Settings& settings, float width, int across);

/// Over T = t √(2g/a), until the front has reached `until` widths or the end time.
struct DamMotion {
  Curve front{"front"};    ///< over a
  Curve height{"height"};  ///< over the height at the start
};

/// The front is where 99 % of the water within a support radius of the floor is behind. What is ahead is
/// spray. The height is that below which 99 % of the water within a support radius of the wall lies.
DamMotion collapse(const DamColumn& column, double until);

/// Martin & Moyce 1952, n² = 2, a = 2.25 in: the front over T, and the height at the wall over T.
const Curve& martin_moyce_front();
const Curve& martin_moyce_height();

}  // namespace meniscus::validation
