// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What the value of a scene file's field may be.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

namespace meniscus {

struct FieldRule {
  double low = -std::numeric_limits<double>::infinity();  ///< of a number, and of each number in a list
  double high = std::numeric_limits<double>::infinity();
  bool above_low = false;            ///< low itself is not allowed
  bool below_high = false;           ///< high itself is not allowed
  bool needed = false;               ///< the key must be there
  std::size_t min_items = 0;         ///< of a list, or characters of a text
  std::size_t max_items = SIZE_MAX;  ///< of a list
};

constexpr FieldRule at_least(double low) {
  FieldRule rule;
  rule.low = low;
  return rule;
}
constexpr FieldRule above(double low) {
  FieldRule rule = at_least(low);
  rule.above_low = true;
  return rule;
}
constexpr FieldRule between(double low, double high) {
  FieldRule rule = at_least(low);
  rule.high = high;
  return rule;
}
/// low < x < high
constexpr FieldRule inside(double low, double high) {
  FieldRule rule = between(low, high);
  rule.above_low = rule.below_high = true;
  return rule;
}
constexpr FieldRule with_items(std::size_t count) {
  FieldRule rule;
  rule.min_items = count;
  return rule;
}
/// A list of so many, each as the rule says.
constexpr FieldRule exactly(std::size_t count, FieldRule rule) {
  rule.min_items = rule.max_items = count;
  return rule;
}
/// What a list's rule says of each item.
constexpr FieldRule of_item(FieldRule rule) {
  rule.min_items = FieldRule{}.min_items;
  rule.max_items = FieldRule{}.max_items;
  return rule;
}
constexpr FieldRule required(FieldRule rule) {
  rule.needed = true;
  return rule;
}

inline constexpr FieldRule any_value{};
inline constexpr FieldRule positive = above(0);
inline constexpr FieldRule not_negative = at_least(0);
inline constexpr FieldRule not_empty = with_items(1);

}  // namespace meniscus
