// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reads single values of a scene document.
#include "sdk/scene/scene_values.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace meniscus {
namespace {

using Json = nlohmann::json;

[[noreturn]] void fail_type(const Json& json, const ScenePlace& place, const std::string& wanted) {
  place.fail(shown(json) + " is not allowed", "must be " + wanted);
}

double read_number(const Json& json, const ScenePlace& place, const FieldRule& rule, const char* wanted) {
  if (!json.is_number()) fail_type(json, place, wanted);
  const double x = json.get<double>();
  if (!in_range(x, rule)) {
    const std::string range = range_text(rule);
    fail_type(json, place, range.empty() ? "a finite number" : range);  // else it is NaN
  }
  return x;
}

template <class T>
T read_whole(const Json& json, const ScenePlace& place, const FieldRule& rule) {
  const double x = read_number(json, place, rule, "a whole number");
  if (x != std::floor(x)) fail_type(json, place, "a whole number");
  constexpr std::numeric_limits<T> limits;
  if (x < limits.min() || x > limits.max()) fail_type(json, place, "a whole number of 32 bits");
  return T(x);
}

template <std::size_t count>
std::array<float, count> read_numbers(const Json& json, const ScenePlace& place, const FieldRule& rule,
                                      const char* wanted) {
  if (!json.is_array() || json.size() != count) fail_type(json, place, wanted);
  std::array<float, count> values;
  for (std::size_t i = 0; i < count; ++i) read_plain(json[i], place.item(i), rule, values[i]);
  return values;
}

}  // namespace

std::string shown(const Json& json) {
  if (json.is_object()) return "an object";
  if (json.is_array()) return "an array of " + std::to_string(json.size());
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  return text.size() <= 60 ? text : text.substr(0, 57) + "...";
}

void read_plain(const Json& json, const ScenePlace& place, const FieldRule& rule, float& value) {
  const double x = read_number(json, place, rule, "a number");
  if (!(std::fabs(x) <= double(std::numeric_limits<float>::max()))) {
    fail_type(json, place, "a finite number of single precision");
  }
  value = float(x) * unit_of(rule);
  // A positive number below the smallest float becomes 0, which the rule may not allow.
  if (!in_range(value, rule) && value == 0) fail_type(json, place, "far enough from 0 for single precision");
}

void read_plain(const Json& json, const ScenePlace& place, const FieldRule& rule, int& value) {
  value = read_whole<int>(json, place, rule);
}

void read_plain(const Json& json, const ScenePlace& place, const FieldRule& rule, uint32_t& value) {
  value = read_whole<uint32_t>(json, place, rule);
}

void read_plain(const Json& json, const ScenePlace& place, const FieldRule&, bool& value) {
  if (!json.is_boolean()) fail_type(json, place, "true or false");
  value = json.get<bool>();
}

void read_plain(const Json& json, const ScenePlace& place, const FieldRule& rule, std::string& value) {
  if (!json.is_string()) fail_type(json, place, "text in quotes");
  value = json.get<std::string>();
  if (value.size() < rule.min_items) fail_type(json, place, "text that is not empty");
}

void read_plain(const Json& json, const ScenePlace& place, const FieldRule& rule, Vec3& value) {
  const auto v = read_numbers<3>(json, place, rule, "an array of 3 numbers");
  value = {v[0], v[1], v[2]};
}

void read_plain(const Json& json, const ScenePlace& place, const FieldRule& rule, Quat& value) {
  const auto q = read_numbers<4>(json, place, rule,
                                 "an array of 4 numbers [x, y, z, w], or an object with axis and degrees");
  const double length = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
  if (!(length > 1e-6))
    place.fail("a quaternion near zero is no rotation", "its length must be greater than 1e-06");
  value = {float(q[0] / length), float(q[1] / length), float(q[2] / length), float(q[3] / length)};
}

}  // namespace meniscus
