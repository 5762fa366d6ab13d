// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Arithmetic on curves: interpolation, errors, periods.
#include "sdk/validation/curves.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace meniscus::validation {
namespace {

double interpolated(const std::vector<double>& from, const std::vector<double>& to, std::size_t k, double x) {
  return to[k - 1] + (x - from[k - 1]) / (from[k] - from[k - 1]) * (to[k] - to[k - 1]);
}

double square(double x) {
  return x * x;
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

double percentile(std::vector<float> values, double fraction) {
  const double rank = std::ceil(fraction * static_cast<double>(values.size()));
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::max(rank, 1.0)) - 1;
  std::nth_element(values.begin(), at, values.end());
  return double{*at};
}

}  // namespace meniscus::validation
