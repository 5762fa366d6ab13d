// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Points sorted by grid cell, to find those near a place. The host fills the table; kernels can query it.
#pragma once

#include <bit>
#include <cmath>
#include <numeric>
#include <span>
#include <vector>

#include "pbd/device/base/view.h"
#include "pbd/math/vec.h"

namespace meniscus {

struct PointTableView {
  pbd::View<const uint32_t> start;   ///< by bucket, and one more; the number of buckets is a power of two
  pbd::View<const uint32_t> number;  ///< of points, by bucket
  float cell = 1;                    ///< m

  struct Cell {
    int32_t x, y, z;
  };

  MENISCUS_HD static int32_t cell_along(float x, float cell) {
    constexpr float far = 1 << 30;
    return static_cast<int32_t>(pbd::clamp(floorf(x / cell), -far, far));
  }
  MENISCUS_HD uint32_t bucket(Cell c) const {
    const uint32_t hash = static_cast<uint32_t>(c.x) * 73856093u ^ static_cast<uint32_t>(c.y) * 19349663u ^
                          static_cast<uint32_t>(c.z) * 83492791u;
    return (hash ^ hash >> 15) & (start.count - 2);
  }
  MENISCUS_HD Cell cell_of(Vec3 p) const {
    return {cell_along(p.x, cell), cell_along(p.y, cell), cell_along(p.z, cell)};
  }

  /// Calls visit(number) for each point within a cell's size of p. It may visit other points as well, and a
  /// point more than once.
  template <class Visit>
  MENISCUS_HD void for_each_near(Vec3 p, const Visit& visit) const {
    const Cell c = cell_of(p);
    for (int32_t k = 0; k < 27; ++k) {
      const uint32_t b = bucket({c.x + k % 3 - 1, c.y + k / 3 % 3 - 1, c.z + k / 9 - 1});
      for (uint32_t at = start[b]; at < start[b + 1]; ++at) visit(number[at]);
    }
  }
};

class PointTable {
 public:
  static size_t buckets_for(size_t points) { return std::bit_ceil(2 * points + 2); }

  void fill(std::span<const Vec3> points, float cell) {
    cell_ = cell;
    start_.assign(buckets_for(points.size()) + 1, 0);
    number_.resize(points.size());
    for (Vec3 p : points) ++start_[bucket_of(p)];
    std::inclusive_scan(start_.begin(), start_.end(), start_.begin());
    for (size_t i = points.size(); i-- > 0;) number_[--start_[bucket_of(points[i])]] = uint32_t(i);
  }

  std::span<const uint32_t> start() const { return start_; }
  std::span<const uint32_t> number() const { return number_; }
  PointTableView view() const {
    return {{start_.data(), uint32_t(start_.size())}, {number_.data(), uint32_t(number_.size())}, cell_};
  }

 private:
  uint32_t bucket_of(Vec3 p) const { return view().bucket(view().cell_of(p)); }

  std::vector<uint32_t> start_, number_;
  float cell_ = 1;
};

}  // namespace meniscus
