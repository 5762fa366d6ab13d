// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reads poses from lines of numbers.
#include "sdk/motion/pose_lines.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "collision/mesh/file/defect.h"
#include "pbd/math/vec.h"

namespace meniscus::motion {

namespace {

using collision::FileDefect;

std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view between = ",; \t\r";
  std::vector<std::string_view> words;
  for (size_t at = line.find_first_not_of(between); at != std::string_view::npos;) {
    const size_t end = std::min(line.find_first_of(between, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(between, end);
  }
  return words;
}

Keyframe keyframe_of(const std::vector<std::string_view>& words, int line) {
  const std::string here = " in line " + std::to_string(line);
  if (words.size() != 8)
    throw FileDefect("has " + std::to_string(words.size()) + " values" + here +
                     ", not 8: time, x, y, z, and the quaternion x, y, z, w");
  float x[8];
  for (size_t k = 0; k < 8; ++k) {
    const auto number = collision::number_of<float>(words[k]);
    if (!number || !std::isfinite(*number))
      throw FileDefect("has no finite number" + here + ": " + collision::in_quotes(words[k]));
    x[k] = *number;
  }
  const Quat turn{x[4], x[5], x[6], x[7]};
  const float norm = std::sqrt(turn.x * turn.x + turn.y * turn.y + turn.z * turn.z + turn.w * turn.w);
  if (!(std::fabs(norm - 1) < 0.01f))
    throw FileDefect("has a quaternion of length " + std::to_string(norm) + here + ", not 1");
  return {x[0], {{x[1], x[2], x[3]}, normalized(turn)}};
}

}  // namespace

std::vector<Keyframe> read_pose_lines(std::string_view text) {
  std::vector<Keyframe> keyframes;
  int number = 0;
  bool is_first = true;
  while (!text.empty()) {
    const size_t end = std::min(text.find('\n'), text.size());
    const std::vector<std::string_view> words = words_of(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    ++number;
    if (words.empty() || words.front().starts_with('#')) continue;
    const bool has_names = is_first && !collision::number_of<float>(words.front());
    is_first = false;
    if (!has_names) keyframes.push_back(keyframe_of(words, number));
  }
  if (keyframes.empty()) throw FileDefect("has no pose");
  return keyframes;
}

}  // namespace meniscus::motion
