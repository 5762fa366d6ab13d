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
#include <span>
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
    if (points_.size() == points.size()) {
      for (size_t t = 0; t < triangles_.size(); t += 3) crossed += count_through(t, vertices, points);
    }
    vertices_.assign(vertices.begin(), vertices.end());
    points_.assign(points.begin(), points.end());
    return crossed;
  }

 private:
  using Double3 = std::array<double, 3>;

  static Double3 minus(Vec3 a, Vec3 b) { return {double{a.x} - b.x, double{a.y} - b.y, double{a.z} - b.z}; }
  static Double3 between(const Double3& a, const Double3& b, double t) {
    return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
  }
  static double triple(const Double3& a, const Double3& b, const Double3& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  }

  size_t count_through(size_t t, std::span<const Vec3> vertices, std::span<const Vec3> points) const {
    Vec3 lower{1e30f, 1e30f, 1e30f}, upper = -1.0f * lower;
    for (size_t k = 0; k < 3; ++k) {
      for (Vec3 x : {vertices_[triangles_[t + k]], vertices[triangles_[t + k]]}) {
        lower = {std::min(lower.x, x.x), std::min(lower.y, x.y), std::min(lower.z, x.z)};
        upper = {std::max(upper.x, x.x), std::max(upper.y, x.y), std::max(upper.z, x.z)};
      }
    }
    size_t crossed = 0;
    for (size_t i = 0; i < points.size(); ++i) {
      const Vec3 a = points_[i], b = points[i];
      if (std::max(a.x, b.x) < lower.x || std::min(a.x, b.x) > upper.x || std::max(a.y, b.y) < lower.y ||
          std::min(a.y, b.y) > upper.y || std::max(a.z, b.z) < lower.z || std::min(a.z, b.z) > upper.z)
        continue;
      crossed += passes(t, i, vertices, points);
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

  /// Whether the origin, which lies in the triangle's plane, lies in the triangle.
  static bool inside(const Double3& a, const Double3& b, const Double3& c) {
    const Double3 e{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, f{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    const Double3 n{e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]};
    return triple(a, b, n) > 0 && triple(b, c, n) > 0 && triple(c, a, n) > 0;
  }

  std::vector<Vec3> vertices_, points_;
  std::vector<uint32_t> triangles_;
};

}  // namespace meniscus::tests
