// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "sdk/cli/way_columns.h"

#include <cmath>
#include <numeric>

namespace meniscus::cli {
namespace {

float columns_per_metre(std::size_t columns, float extent) {
  return extent > 0 ? static_cast<float>(columns) / extent : 0.0f;
}

std::size_t column(float at, std::size_t columns) {
  // What is not finite stands with the first.
  return static_cast<std::size_t>(std::fmin(std::fmax(at, 0.0f), static_cast<float>(columns - 1)));
}

}  // namespace

WayColumns::WayColumns(const std::vector<Way>& ways) : ways_(ways.size()), start_(each * each + 1, 0) {
  if (ways.empty()) return;
  Vec3 upper = lower_ = around(ways.front()).lower;
  for (const Way& way : ways) {
    const Aabb box = around(way);
    lower_ = min(lower_, box.lower);
    upper = max(upper, box.lower);
    longest_ = max(longest_, box.upper - box.lower);
  }
  per_x_ = columns_per_metre(each, upper.x - lower_.x);
  per_z_ = columns_per_metre(each, upper.z - lower_.z);

  const auto column_of = [&](const Way& way) {
    const Place place = place_of(around(way).lower);
    return each * place.z + place.x;
  };
  for (const Way& way : ways) ++start_[column_of(way) + 1];
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  std::vector<std::size_t> next = start_;
  for (const Way& way : ways) ways_[next[column_of(way)]++] = way;
}

WayColumns::Place WayColumns::place_of(Vec3 point) const {
  return {column((point.x - lower_.x) * per_x_, each), column((point.z - lower_.z) * per_z_, each)};
}

}  // namespace meniscus::cli
