// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The stretch of a sheet's edges, for benchmarks.
#pragma once

#include <meniscus/types.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "tests/bench/bench.h"

namespace meniscus::bench {

inline double distance(Vec3 a, Vec3 b) {
  return std::hypot(double(b.x) - a.x, double(b.y) - a.y, double(b.z) - a.z);
}

struct Stretch {
  double mean = 0, p99 = 0, max = 0;  // of l/L
};

/// The lengths of a sheet's edges over those at rest. Those along the chains are told apart from the
/// diagonals, which lengthen where cloth shears, as it must over a sphere.
class EdgeStretch {
 public:
  /// `columns` vertices in a row, which are numbered row by row.
  EdgeStretch(std::span<const Vec3> rest, std::span<const uint32_t> triangles, uint32_t columns) {
    for (size_t t = 0; t < triangles.size(); t += 3) {
      for (size_t k = 0; k < 3; ++k) {
        const uint32_t a = triangles[t + k], b = triangles[t + (k + 1) % 3];
        edges_.push_back({std::min(a, b), std::max(a, b)});
      }
    }
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    const auto diagonals = std::partition(edges_.begin(), edges_.end(), [&](const Edge& e) {
      return e[1] - e[0] == 1 || e[1] - e[0] == columns;
    });
    chains_ = static_cast<size_t>(diagonals - edges_.begin());
    for (const Edge& e : edges_) rest_.push_back(distance(rest[e[0]], rest[e[1]]));
  }

  Stretch of_all(std::span<const Vec3> now) const { return of(now, edges_.size()); }
  Stretch of_chains(std::span<const Vec3> now) const { return of(now, chains_); }

 private:
  using Edge = std::array<uint32_t, 2>;

  Stretch of(std::span<const Vec3> now, size_t count) const {
    std::vector<double> stretch;
    for (size_t k = 0; k < count; ++k)
      stretch.push_back(distance(now[edges_[k][0]], now[edges_[k][1]]) / rest_[k]);
    const double sum = std::accumulate(stretch.begin(), stretch.end(), 0.0);
    const double max = *std::max_element(stretch.begin(), stretch.end());
    return {sum / double(count), quantile(std::move(stretch), 0.99), max};
  }

  std::vector<Edge> edges_;  // along the chains first
  size_t chains_ = 0;
  std::vector<double> rest_;  // m
};

}  // namespace meniscus::bench
