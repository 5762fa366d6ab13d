// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Arithmetic on curves: interpolation, errors, periods.
#pragma once

#include <vector>

#include "sdk/validation/case.h"

namespace meniscus::validation {

/// Linear between the two points around x, and beyond the ends along the last two. At least two points.
double value_at(const Curve& curve, double x);
/// The first x, ascending, at which a curve that rises or falls as a whole takes the value.
double x_at(const Curve& curve, double value);

/// Root mean square, over the points of `reference`, of curve(x + shift)/reference − 1.
double rms_relative_error(const Curve& curve, const Curve& reference, double shift = 0);
/// Of all shifts between −most and most, that with the least rms_relative_error.
double best_shift(const Curve& curve, const Curve& reference, double most);

/// Mean time between crossings of `level` upwards. NaN with fewer than two of them.
double period_of(const Curve& curve, double level = 0);

/// A wave that dies out.
struct DampedWave {
  double period = 0;
  double damping = 0;  ///< ratio to critical damping: per period the wave falls to exp(−2π · damping)
};
/// The wave e^(−2π ζ t/T) cos(2π t/T + φ), plus a constant, that fits best by least squares. Periods from
/// half to twice `expected` are tried, and a damping up to .5. At least ten points, over more than a period.
DampedWave fitted_wave(const Curve& curve, double expected);

/// The value that is not exceeded by `fraction` of the values, of which there is at least one.
double percentile(std::vector<float> values, double fraction);

}  // namespace meniscus::validation
