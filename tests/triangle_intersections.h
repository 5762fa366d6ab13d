// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Counts the triangles that pass through one another, without rounding: positions are taken to 2⁻³⁷ m, the
// ten-thousandth part of a float's last bit at 1 m, and from there on all is in integers.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <stdexcept>
#include <vector>

#include <meniscus/types.h>

namespace meniscus::tests {

class TriangleIntersections {
 public:
  using Triangle = std::array<uint32_t, 3>;

  TriangleIntersections(std::span<const Vec3> vertices, std::span<const Triangle> triangles)
      : triangles_(triangles) {
    for (Vec3 v : vertices) points_.push_back({fixed(v.x), fixed(v.y), fixed(v.z)});
  }

  /// Pairs of triangles of which an edge of one goes through the inside of the other.
  size_t count() const {
    std::vector<Box> boxes;
    for (uint32_t t = 0; t < triangles_.size(); ++t) boxes.push_back(box_of(t));
    std::sort(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) { return a.lower[0] < b.lower[0]; });
    size_t found = 0;
    for (size_t i = 0; i < boxes.size(); ++i) {
      for (size_t j = i + 1; j < boxes.size() && boxes[j].lower[0] <= boxes[i].upper[0]; ++j)
        found += overlap(boxes[i], boxes[j]) && intersect(boxes[i].triangle, boxes[j].triangle);
    }
    return found;
  }

 private:
  using Int = __int128;
  using Point = std::array<int64_t, 3>;
  struct Box {
    Point lower, upper;
    uint32_t triangle;
  };

  static int64_t fixed(float x) {
    if (!(std::fabs(x) < 4)) throw std::out_of_range("a vertex is further than 4 m from the origin");
    return std::llrint(std::ldexp(static_cast<double>(x), 37));
  }

  Box box_of(uint32_t t) const {
    const Point &a = points_[triangles_[t][0]], &b = points_[triangles_[t][1]],
                &c = points_[triangles_[t][2]];
    Box box{a, a, t};
    for (size_t k = 0; k < 3; ++k) {
      box.lower[k] = std::min({a[k], b[k], c[k]});
      box.upper[k] = std::max({a[k], b[k], c[k]});
    }
    return box;
  }
  static bool overlap(const Box& a, const Box& b) {
    for (size_t k = 1; k < 3; ++k)
      if (a.lower[k] > b.upper[k] || b.lower[k] > a.upper[k]) return false;
    return true;
  }

  bool intersect(uint32_t s, uint32_t t) const {
    for (size_t k = 0; k < 3; ++k) {
      if (passes(triangles_[s][k], triangles_[s][(k + 1) % 3], triangles_[t])) return true;
      if (passes(triangles_[t][k], triangles_[t][(k + 1) % 3], triangles_[s])) return true;
    }
    return false;
  }

  bool passes(uint32_t p, uint32_t q, const Triangle& t) const {
    if (side(t[0], t[1], t[2], p) * side(t[0], t[1], t[2], q) >= 0) return false;
    const int a = side(p, q, t[0], t[1]);
    return a != 0 && side(p, q, t[1], t[2]) == a && side(p, q, t[2], t[0]) == a;
  }

  /// The sign of the volume of (a, b, c, d). Differences have 41 bits, so that the sum has less than 127.
  int side(uint32_t a, uint32_t b, uint32_t c, uint32_t d) const {
    const auto from_a = [&](uint32_t v, size_t k) { return Int{points_[v][k] - points_[a][k]}; };
    const auto minor = [&](size_t k, size_t l) {
      return from_a(b, k) * from_a(c, l) - from_a(b, l) * from_a(c, k);
    };
    const Int volume = minor(1, 2) * from_a(d, 0) + minor(2, 0) * from_a(d, 1) + minor(0, 1) * from_a(d, 2);
    return (volume > 0) - (volume < 0);
  }

  std::span<const Triangle> triangles_;
  std::vector<Point> points_;
};

}  // namespace meniscus::tests
