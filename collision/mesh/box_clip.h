// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The part of a mesh inside a box: convex polygons that are cut by planes along the axes.
#pragma once

#include <array>
#include <vector>

#include "collision/mesh/mesh.h"

namespace meniscus::collision {

using Double3 = std::array<double, 3>;

/// m
struct DoubleBox {
  Double3 lower, upper;
};

/// The corners of a convex polygon. A triangle that a box cuts has nine at most.
class ClippedPolygon {
 public:
  ClippedPolygon(const TriangleMesh& mesh, const std::array<uint32_t, 3>& triangle);

  /// Keeps what is at or above `at` along an axis, or with sign = −1 what is at or below it.
  void cut(int axis, double at, double sign);
  /// Keeps what is within the box.
  void cut(const DoubleBox& box);

  int count() const { return count_; }
  const Double3& operator[](int i) const { return corners_[static_cast<size_t>(i)]; }

 private:
  int count_ = 3;
  std::array<Double3, 10> corners_;
};

/// The point of a segment where a coordinate is `at`. That coordinate is then exact.
Double3 point_at(const Double3& a, const Double3& b, int axis, double at);

bool are_apart(const TriangleMesh& mesh, const std::array<uint32_t, 3>& triangle, const DoubleBox& box);

/// m³, of the part of a closed mesh inside a box; exact but for rounding. It is the flux of (clamp(x) −
/// lower.x) along x through the surface, within the box's range of y and z. The divergence of that is 1 in
/// the box and 0 before and behind it.
double volume_within(const TriangleMesh& mesh, const DoubleBox& box);

}  // namespace meniscus::collision
