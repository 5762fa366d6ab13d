// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The values at which something may be wrong with a number of a definition.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "tests/unit/sdk/fields/number_walk.h"

namespace meniscus::tests {

/// The bounds of a number, the values beside them, and what is not finite.
inline std::vector<double> trials(const Number& number) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const FieldRule& rule = number.rule;
  std::vector<double> values;
  const auto add_around = [&](double bound) {
    if (number.is_whole) {
      for (const double x : {bound - 1, bound, bound + 1}) values.push_back(x);
    } else {
      const auto f = static_cast<float>(bound);
      const auto far = std::numeric_limits<float>::infinity();
      for (const double x : {double{std::nextafter(f, -far)}, bound, double{std::nextafter(f, far)}})
        values.push_back(x);
    }
  };
  if (!number.is_rotation && std::isfinite(rule.low)) add_around(rule.low);
  if (!number.is_rotation && std::isfinite(rule.high)) add_around(rule.high);
  if (number.is_whole) {
    const double least = number.is_signed ? double{std::numeric_limits<int>::min()} : 0;
    const double most = number.is_signed ? double{std::numeric_limits<int>::max()}
                                         : double{std::numeric_limits<uint32_t>::max()};
    std::erase_if(values, [&](double x) { return x < least || x > most; });  // no member holds them
  } else {
    for (const double x : {std::numeric_limits<double>::quiet_NaN(), infinite, -infinite})
      values.push_back(x);
  }
  return values;
}

/// Finite values far from all that a simulation needs.
inline std::vector<double> huge_trials(const Number& number) {
  if (number.is_whole) return {};
  constexpr double most = std::numeric_limits<float>::max();
  return {1e12, -1e12, most, -most};
}

/// Whether the rule alone allows a value, as floats or whole numbers hold it.
inline bool is_in(const Number& number, double value) {
  FieldRule rule = number.rule;
  if (!number.is_whole) {
    if (!std::isfinite(value)) return false;
    if (value != rule.low && value != rule.high) value = static_cast<float>(value);
  }
  return in_range(value, rule);
}

}  // namespace meniscus::tests
