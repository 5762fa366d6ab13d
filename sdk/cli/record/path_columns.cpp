// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Sorts displacements into columns.
#include "sdk/cli/record/path_columns.h"

#include <cmath>
#include <numeric>

namespace meniscus::cli {
namespace {

float columns_per_metre(std::size_t columns, float extent) {
  return extent > 0 ? static_cast<float>(columns) / extent : 0.0f;
}

std::size_t column(float at, std::size_t columns) {
  // Values that are not finite go to the first column.
  return static_cast<std::size_t>(std::fmin(std::fmax(at, 0.0f), static_cast<float>(columns - 1)));
}

}  // namespace

// Displacements far from the region must not widen the columns: water that has run off falls for ever.
PathColumns::PathColumns(const std::vector<Path>& paths, const Aabb& region)
    : start_(each * each + 1, 0),
      lower_(region.lower),
      per_x_(columns_per_metre(each, region.upper.x - region.lower.x)),
      per_z_(columns_per_metre(each, region.upper.z - region.lower.z)) {
  std::vector<Path> inside;
  for (const Path& path : paths) {
    const Aabb box = around(path);
    if (!pbd::overlap(box, region)) continue;
    inside.push_back(path);
    longest_ = max(longest_, box.upper - box.lower);
  }
  const auto column_of = [&](const Path& path) {
    const Place place = place_of(around(path).lower);
    return each * place.z + place.x;
  };
  for (const Path& path : inside) ++start_[column_of(path) + 1];
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  std::vector<std::size_t> next = start_;
  paths_.resize(inside.size());
  for (const Path& path : inside) paths_[next[column_of(path)]++] = path;
}

PathColumns::Place PathColumns::place_of(Vec3 point) const {
  return {column((point.x - lower_.x) * per_x_, each), column((point.z - lower_.z) * per_z_, each)};
}

}  // namespace meniscus::cli
