// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Counts the points that pass through moving triangles, in double precision: from one state to the next both
// go along straight lines.
#pragma once

#include <meniscus/types.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <future>
#include <span>
#include <thread>
#include <vector>

namespace meniscus::tests {

class SheetCrossings {
 public:
  SheetCrossings(std::span<const Vec3> vertices, std::span<const uint32_t> triangles)
      : vertices_(vertices.begin(), vertices.end()), triangles_(triangles.begin(), triangles.end()) {}

  /// How many pairs of a point and a triangle have crossed since the last call; points are told by their
  /// places, and there must be as many as before.
  size_t advance(std::span<const Vec3> vertices, std::span<const Vec3> points) {
    size_t crossed = 0;
    if (points_.size() == points.size() && !points.empty()) {
      sort(points, extent_of(vertices));
      crossed = count(vertices, points);
    }
    vertices_.assign(vertices.begin(), vertices.end());
    points_.assign(points.begin(), points.end());
    return crossed;
  }

 private:
  using Double3 = std::array<double, 3>;

  /// On all cores: each has every so many-th triangle.
  size_t count(std::span<const Vec3> vertices, std::span<const Vec3> points) const {
    const size_t threads = std::max(1u, std::thread::hardware_concurrency());
    std::vector<std::future<size_t>> counts;
    for (size_t n = 0; n < threads; ++n) {
      counts.push_back(std::async(std::launch::async, [&, n] {
        size_t crossed = 0;
        for (size_t t = 3 * n; t < triangles_.size(); t += 3 * threads)
          crossed += count_through(t, vertices, points);
        return crossed;
      }));
    }
    size_t crossed = 0;
    for (auto& count : counts) crossed += count.get();
    return crossed;
  }

  static Double3 minus(Vec3 a, Vec3 b) { return {double{a.x} - b.x, double{a.y} - b.y, double{a.z} - b.z}; }
  static Double3 between(const Double3& a, const Double3& b, double t) {
    return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
  }
  static double triple(const Double3& a, const Double3& b, const Double3& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  }

  static Aabb way(Vec3 a, Vec3 b) {
    return {{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
            {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}};
  }
  static bool overlap(const Aabb& a, const Aabb& b) {
    return a.lower.x <= b.upper.x && b.lower.x <= a.upper.x && a.lower.y <= b.upper.y &&
           b.lower.y <= a.upper.y && a.lower.z <= b.upper.z && b.lower.z <= a.upper.z;
  }

  // Points are in columns along y, each in all columns that its displacement passes through.
  static constexpr size_t columns = 64;  // on each of the two axes

  struct Range {
    size_t x0, x1, z0, z1;
  };
  size_t column(float at, float lower, float upper) const {
    const double share = (double{at} - lower) / std::max(1e-30, double{upper} - lower);
    return size_t(std::clamp(share, 0.0, 1.0) * (columns - 1));
  }
  Range columns_of(const Aabb& box) const {
    return {column(box.lower.x, extent_.lower.x, extent_.upper.x),
            column(box.upper.x, extent_.lower.x, extent_.upper.x),
            column(box.lower.z, extent_.lower.z, extent_.upper.z),
            column(box.upper.z, extent_.lower.z, extent_.upper.z)};
  }

  /// The extent of the sheet over its displacement.
  Aabb extent_of(std::span<const Vec3> vertices) const {
    Aabb extent{vertices[0], vertices[0]};
    for (std::span<const Vec3> some : {vertices, std::span<const Vec3>(vertices_)}) {
      for (Vec3 x : some) extent = {way(extent.lower, x).lower, way(extent.upper, x).upper};
    }
    return extent;
  }

  /// Those that come near the sheet.
  void sort(std::span<const Vec3> points, const Aabb& sheet) {
    extent_ = sheet;
    in_column_.resize(columns * columns);
    for (auto& column : in_column_) column.clear();
    for (size_t i = 0; i < points.size(); ++i) {
      const Aabb of_point = way(points_[i], points[i]);
      if (!overlap(of_point, sheet)) continue;
      const Range r = columns_of(of_point);
      for (size_t x = r.x0; x <= r.x1; ++x)
        for (size_t z = r.z0; z <= r.z1; ++z) in_column_[columns * x + z].push_back(i);
    }
  }

  size_t count_through(size_t t, std::span<const Vec3> vertices, std::span<const Vec3> points) const {
    Aabb box = way(vertices[triangles_[t]], vertices_[triangles_[t]]);
    for (size_t k = 1; k < 3; ++k) {
      const Aabb corner = way(vertices_[triangles_[t + k]], vertices[triangles_[t + k]]);
      box = {way(box.lower, corner.lower).lower, way(box.upper, corner.upper).upper};
    }
    const Range r = columns_of(box);
    size_t crossed = 0;
    for (size_t x = r.x0; x <= r.x1; ++x) {
      for (size_t z = r.z0; z <= r.z1; ++z) {
        for (size_t i : in_column_[columns * x + z]) {
          const Aabb of_point = way(points_[i], points[i]);
          if (!overlap(of_point, box)) continue;
          const Range own = columns_of(of_point);  // in the first column that both are in
          if (x == std::max(r.x0, own.x0) && z == std::max(r.z0, own.z0))
            crossed += passes(t, i, vertices, points);
        }
      }
    }
    return crossed;
  }

  /// The corners as seen from the point, at the start and at the end. Their volume is a cubic in time.
  bool passes(size_t t, size_t i, std::span<const Vec3> vertices, std::span<const Vec3> points) const {
    Double3 start[3], end[3];
    for (size_t k = 0; k < 3; ++k) {
      start[k] = minus(vertices_[triangles_[t + k]], points_[i]);
      end[k] = minus(vertices[triangles_[t + k]], points[i]);
    }
    if (stays_on_one_side(start, end)) return false;
    const auto volume = [&](double time) {
      return triple(between(start[0], end[0], time), between(start[1], end[1], time),
                    between(start[2], end[2], time));
    };
    constexpr int pieces = 64;  // a cubic has no more than three roots
    for (int k = 0; k < pieces; ++k) {
      double low = double(k) / pieces, high = double(k + 1) / pieces;
      const bool sign = volume(low) > 0;
      if (sign == (volume(high) > 0)) continue;
      for (int round = 0; round < 60; ++round) {
        const double middle = 0.5 * (low + high);
        ((volume(middle) > 0) == sign ? low : high) = middle;
      }
      if (inside(between(start[0], end[0], low), between(start[1], end[1], low),
                 between(start[2], end[2], low)))
        return true;
    }
    return false;
  }

  /// Where Bernstein's coefficients of the cubic have all one sign, it has no root.
  static bool stays_on_one_side(const Double3 (&s)[3], const Double3 (&e)[3]) {
    const double c[] = {triple(s[0], s[1], s[2]),
                        triple(e[0], s[1], s[2]) + triple(s[0], e[1], s[2]) + triple(s[0], s[1], e[2]),
                        triple(s[0], e[1], e[2]) + triple(e[0], s[1], e[2]) + triple(e[0], e[1], s[2]),
                        triple(e[0], e[1], e[2])};
    return std::all_of(c, c + 4, [](double x) { return x > 0; }) ||
           std::all_of(c, c + 4, [](double x) { return x < 0; });
  }

  /// Whether the origin, which lies in the triangle's plane, lies in the triangle.
  static bool inside(const Double3& a, const Double3& b, const Double3& c) {
    const Double3 e{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, f{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    const Double3 n{e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]};
    return triple(a, b, n) > 0 && triple(b, c, n) > 0 && triple(c, a, n) > 0;
  }

  std::vector<Vec3> vertices_, points_;
  std::vector<uint32_t> triangles_;
  Aabb extent_{};
  std::vector<std::vector<size_t>> in_column_;
};

}  // namespace meniscus::tests
