// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Arithmetic on curves: interpolation, errors, periods.
#include "sdk/validation/curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace meniscus::validation {
namespace {

double interpolated(const std::vector<double>& from, const std::vector<double>& to, std::size_t k, double x) {
  return to[k - 1] + (x - from[k - 1]) / (from[k] - from[k - 1]) * (to[k] - to[k - 1]);
}

double square(double x) {
  return x * x;
}

double product(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// Removes from `values` their part along a unit vector.
void remove_part(std::vector<double>& values, const std::vector<double>& unit) {
  const double part = product(values, unit);
  for (std::size_t k = 0; k < values.size(); ++k) values[k] -= part * unit[k];
}

/// The sum of squares that is left of a curve by the best wave of this period and damping, and a constant.
double misfit(const Curve& curve, const DampedWave& wave) {
  const std::size_t count = curve.x.size();
  std::array<std::vector<double>, 3> parts{std::vector<double>(count), std::vector<double>(count),
                                           std::vector<double>(count, 1.0)};
  for (std::size_t k = 0; k < count; ++k) {
    const double phase = 2 * std::numbers::pi * (curve.x[k] - curve.x[0]) / wave.period;
    parts[0][k] = std::exp(-wave.damping * phase) * std::cos(phase);
    parts[1][k] = std::exp(-wave.damping * phase) * std::sin(phase);
  }
  std::vector<double> left = curve.y;
  for (std::size_t n = 0; n < parts.size(); ++n) {  // Gram–Schmidt
    for (std::size_t m = 0; m < n; ++m) remove_part(parts[n], parts[m]);
    const double length = std::sqrt(product(parts[n], parts[n]));
    for (double& value : parts[n]) value /= length;
    remove_part(left, parts[n]);
  }
  return product(left, left);
}

}  // namespace

double value_at(const Curve& curve, double x) {
  std::size_t k = 1;
  while (k + 1 < curve.x.size() && curve.x[k] < x) ++k;
  return interpolated(curve.x, curve.y, k, x);
}

double x_at(const Curve& curve, double value) {
  const bool rises = curve.y.back() > curve.y.front();
  std::size_t k = 1;
  while (k + 1 < curve.y.size() && (curve.y[k] < value) == rises) ++k;
  return interpolated(curve.y, curve.x, k, value);
}

double rms_relative_error(const Curve& curve, const Curve& reference, double shift) {
  double sum = 0;
  for (std::size_t k = 0; k < reference.x.size(); ++k)
    sum += square(value_at(curve, reference.x[k] + shift) / reference.y[k] - 1);
  return std::sqrt(sum / static_cast<double>(reference.x.size()));
}

double best_shift(const Curve& curve, const Curve& reference, double most) {
  constexpr int steps = 400;
  double best = 0, least = std::numeric_limits<double>::infinity();
  for (int k = -steps; k <= steps; ++k) {
    const double shift = most * k / steps, error = rms_relative_error(curve, reference, shift);
    if (error < least) {
      least = error;
      best = shift;
    }
  }
  return best;
}

double period_of(const Curve& curve, double level) {
  std::vector<double> crossings;
  for (std::size_t k = 1; k < curve.x.size(); ++k) {
    if (curve.y[k - 1] < level && curve.y[k] >= level)
      crossings.push_back(interpolated(curve.y, curve.x, k, level));
  }
  if (crossings.size() < 2) return std::numeric_limits<double>::quiet_NaN();
  return (crossings.back() - crossings.front()) / static_cast<double>(crossings.size() - 1);
}

DampedWave fitted_wave(const Curve& curve, double expected) {
  constexpr int steps = 10, rounds = 6;
  DampedWave best{expected, 0.25};
  double period_range = 0.5, damping_range = 0.25, least = std::numeric_limits<double>::infinity();
  for (int round = 0; round < rounds; ++round) {
    const DampedWave middle = best;
    for (int i = -steps; i <= steps; ++i) {
      for (int j = -steps; j <= steps; ++j) {
        const DampedWave wave{middle.period * std::exp2(2 * period_range * i / steps),
                              std::clamp(middle.damping + damping_range * j / steps, 0.0, 0.5)};
        const double left = misfit(curve, wave);
        if (left < least) {
          least = left;
          best = wave;
        }
      }
    }
    period_range /= 4;
    damping_range /= 4;
  }
  return best;
}

double percentile(std::vector<float> values, double fraction) {
  const double rank = std::ceil(fraction * static_cast<double>(values.size()));
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::max(rank, 1.0)) - 1;
  std::nth_element(values.begin(), at, values.end());
  return double{*at};
}

}  // namespace meniscus::validation
