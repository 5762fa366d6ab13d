// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Writes values and names as USD's text format has them.
#include "sdk/io/usd/usd_text.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "pbd/math/vec.h"
#include "sdk/io/plain_text.h"

namespace meniscus::io {
namespace {

float finite(float value) {
  return std::isfinite(value) ? value : 0.0f;
}

void add(std::string& text, float value) {
  fmt::format_to(std::back_inserter(text), "{}", finite(value));
}
void add(std::string& text, uint64_t value) {
  fmt::format_to(std::back_inserter(text), "{}", value);
}
void add(std::string& text, uint32_t value) {
  fmt::format_to(std::back_inserter(text), "{}", value);
}
void add(std::string& text, Vec3 v) {
  fmt::format_to(std::back_inserter(text), "({}, {}, {})", finite(v.x), finite(v.y), finite(v.z));
}
void add(std::string& text, TexturePoint p) {
  fmt::format_to(std::back_inserter(text), "({}, {})", finite(p.u), finite(p.v));
}

template <class T>
std::string array_of(std::span<const T> values) {
  std::string text = "[";
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) text += ", ";
    add(text, values[i]);
  }
  text += ']';
  return text;
}

bool is_allowed(char c, bool first) {
  const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  return letter || (!first && c >= '0' && c <= '9');
}

}  // namespace

std::string usd_value(Vec3 v) {
  std::string text;
  add(text, v);
  return text;
}

std::string usd_value(Quat q) {
  return fmt::format("({}, {}, {}, {})", finite(q.w), finite(q.x), finite(q.y), finite(q.z));
}

std::string usd_array(std::span<const Vec3> values) {
  return array_of(values);
}
std::string usd_array(std::span<const TexturePoint> values) {
  return array_of(values);
}
std::string usd_array(std::span<const float> values) {
  return array_of(values);
}
std::string usd_array(std::span<const uint64_t> values) {
  return array_of(values);
}
std::string usd_array(std::span<const uint32_t> values) {
  return array_of(values);
}

std::string usd_extent(std::span<const Vec3> points, float margin) {
  Vec3 lower{INFINITY, INFINITY, INFINITY}, upper = -lower;
  for (const Vec3 p : points) {
    if (!is_finite(p)) continue;
    lower = min(lower, p);
    upper = max(upper, p);
  }
  if (!(lower.x <= upper.x)) return "[]";
  const Vec3 corners[] = {lower - Vec3{margin, margin, margin}, upper + Vec3{margin, margin, margin}};
  return usd_array(std::span<const Vec3>(corners));
}

std::string triangle_counts(std::size_t triangles) {
  const std::vector<uint32_t> counts(triangles, 3);
  return usd_array(std::span<const uint32_t>(counts));
}

std::string triangle_corners(std::span<const std::array<uint32_t, 3>> triangles, uint32_t first) {
  std::vector<uint32_t> corners;
  corners.reserve(3 * triangles.size());
  for (const auto& t : triangles) {
    for (const uint32_t v : t) corners.push_back(v - first);
  }
  return usd_array(std::span<const uint32_t>(corners));
}

std::string usd_text(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : plain_text(text)) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + '"';
}

std::string UsdNames::add(std::string_view name, std::string_view if_empty) {
  std::string start(name.empty() ? if_empty : name);
  for (char& c : start) c = is_allowed(c, false) ? c : '_';
  if (!is_allowed(start.front(), true)) start.insert(start.begin(), '_');
  std::string unique = start;
  for (int number = 2; !taken_.insert(unique).second; ++number) unique = start + '_' + std::to_string(number);
  return unique;
}

}  // namespace meniscus::io
