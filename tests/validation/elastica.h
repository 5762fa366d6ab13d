// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The heavy elastica: a strip that is clamped at one end and bends under its own weight.
#pragma once

#include <array>
#include <cmath>

namespace meniscus::tests {

/// Gravity over its size, along the strip as clamped and across it.
struct Pull {
  double along, across;
};

/// How far the tip of a strip moves across, over its length, under the load B = w L³/D. w is the weight per
/// area and D the bending stiffness:
///
///   θ'' = −B (1 − s) (across cos θ − along sin θ),  θ(0) = 0,  θ'(1) = 0,
///
/// by shooting with Runge & Kutta's method.
inline double elastica_tip(double load, Pull pull) {
  constexpr int steps = 1000;
  constexpr double ds = 1.0 / steps;
  using State = std::array<double, 3>;  // θ, θ', distance across
  const auto slope = [&](double s, const State& y) {
    const double moment = pull.across * std::cos(y[0]) - pull.along * std::sin(y[0]);
    return State{y[1], -load * (1 - s) * moment, std::sin(y[0])};
  };
  const auto after = [](const State& y, double h, const State& k) {
    return State{y[0] + h * k[0], y[1] + h * k[1], y[2] + h * k[2]};
  };
  const auto shoot = [&](double bend) {
    State y{0, bend, 0};
    for (int n = 0; n < steps; ++n) {
      const double s = n * ds;
      const State a = slope(s, y), b = slope(s + ds / 2, after(y, ds / 2, a)),
                  c = slope(s + ds / 2, after(y, ds / 2, b)), d = slope(s + ds, after(y, ds, c));
      for (size_t k = 0; k < 3; ++k) y[k] += ds / 6 * (a[k] + 2 * b[k] + 2 * c[k] + d[k]);
    }
    return y;
  };
  double low = 0, high = load;
  for (int n = 0; n < 50; ++n) {
    const double middle = 0.5 * (low + high);
    (shoot(middle)[1] < 0 ? low : high) = middle;
  }
  return shoot(low)[2];
}

}  // namespace meniscus::tests
