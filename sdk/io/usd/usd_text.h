// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Values and names as USD's text format has them.
#pragma once

#include <meniscus/outputs.h>

#include <array>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <string_view>

namespace meniscus::io {

/// Numbers have all digits that their type needs. A value that is not finite is written as 0, since the
/// format's readers refuse it.
std::string usd_value(Vec3 v);
std::string usd_value(Quat q);  ///< w first
std::string usd_array(std::span<const Vec3> values);
std::string usd_array(std::span<const TexturePoint> values);
std::string usd_array(std::span<const float> values);
std::string usd_array(std::span<const uint64_t> values);
std::string usd_array(std::span<const uint32_t> values);
/// The corners of a box around the points, grown by a margin.
std::string usd_extent(std::span<const Vec3> points, float margin = 0);
/// The numbers of corners of triangles: 3 each.
std::string triangle_counts(std::size_t triangles);
/// Their corners, as numbers from `first` on.
std::string triangle_corners(std::span<const std::array<uint32_t, 3>> triangles, uint32_t first);
/// A text in quotes.
std::string usd_text(std::string_view text);

/// Names of prims with one parent: letters, digits and underscores, each once.
class UsdNames {
 public:
  /// The name, with an underscore for each byte that is not allowed. Where it is taken, a number follows.
  std::string add(std::string_view name, std::string_view if_empty);

 private:
  std::set<std::string> taken_;
};

}  // namespace meniscus::io
