// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What the value of a definition's field may be. fields.h says where rules stand, and who reads them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>

namespace meniscus {

struct FieldRule {
  double low = -std::numeric_limits<double>::infinity();  ///< of a number, and of each number in a list
  double high = std::numeric_limits<double>::infinity();
  bool above_low = false;            ///< low itself is not allowed
  bool below_high = false;           ///< high itself is not allowed
  bool needed = false;               ///< the key must be there
  bool or_infinite = false;          ///< in C++, infinity is allowed; JSON has none
  bool in_degrees = false;           ///< bounds, and files, are in degrees; C++ is in radians
  bool key_only = false;             ///< only files have it: the key has no member
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
/// Allows infinity in C++ as well.
constexpr FieldRule or_infinity(FieldRule rule) {
  rule.or_infinite = true;
  return rule;
}
constexpr FieldRule degrees(FieldRule rule) {
  rule.in_degrees = true;
  return rule;
}
/// For a key that has no member: fields() reads it into a local variable, and sets members by it.
constexpr FieldRule key_only(FieldRule rule) {
  rule.key_only = true;
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

/// The factor from the unit of the rule and of files to the unit of the member.
constexpr float unit_of(const FieldRule& rule) {
  return rule.in_degrees ? std::numbers::pi_v<float> / 180 : 1;
}

/// Whether a number is within the bounds. NaN is not, whatever they are.
constexpr bool in_range(double x, const FieldRule& rule) {
  const bool above = rule.above_low ? x > rule.low : x >= rule.low;
  const bool below = rule.below_high ? x < rule.high : x <= rule.high;
  return above && below;
}

/// The bounds in words, as in "at least 0 and at most 1"; empty where there are none.
std::string range_text(const FieldRule& rule);

}  // namespace meniscus
