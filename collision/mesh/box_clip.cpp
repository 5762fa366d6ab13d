// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Clips triangles to boxes (Sutherland & Hodgman 1974), and sums the volume between them.
#include "collision/mesh/box_clip.h"

#include <algorithm>

namespace meniscus::collision {

namespace {

Double3 corner_of(Vec3 v) {
  return {double{v.x}, double{v.y}, double{v.z}};
}

/// Twice the polygon's area as seen along x, positive where it faces along x, times the mean of x − `from`.
double flux(const ClippedPolygon& polygon, double from) {
  double sum = 0;
  for (int i = 2; i < polygon.count(); ++i) {
    const Double3 &a = polygon[0], &b = polygon[i - 1], &c = polygon[i];
    const double area = (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]);
    sum += area * ((a[0] + b[0] + c[0]) / 3 - from);
  }
  return sum;
}

double twice_area_along_x(const ClippedPolygon& polygon) {
  double sum = 0;
  for (int i = 2; i < polygon.count(); ++i) {
    const Double3 &a = polygon[0], &b = polygon[i - 1], &c = polygon[i];
    sum += (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]);
  }
  return sum;
}

}  // namespace

ClippedPolygon::ClippedPolygon(const TriangleMesh& mesh, const std::array<uint32_t, 3>& triangle) {
  for (size_t k = 0; k < 3; ++k) corners_[k] = corner_of(mesh.vertices[triangle[k]]);
}

Double3 point_at(const Double3& a, const Double3& b, int axis, double at) {
  const auto k = static_cast<size_t>(axis);
  // From the lower end, so that both triangles of an edge get the same point.
  const bool in_order = a <= b;
  const Double3 &from = in_order ? a : b, &to = in_order ? b : a;
  const double t = (at - from[k]) / (to[k] - from[k]);
  Double3 p;
  for (size_t i = 0; i < 3; ++i) p[i] = from[i] + t * (to[i] - from[i]);
  p[k] = at;
  return p;
}

void ClippedPolygon::cut(int axis, double at, double sign) {
  const auto k = static_cast<size_t>(axis);
  std::array<Double3, 10> kept;
  size_t count = 0;
  for (int i = 0; i < count_; ++i) {
    const Double3 &a = (*this)[i], &b = (*this)[(i + 1) % count_];
    const double height_a = sign * (a[k] - at), height_b = sign * (b[k] - at);
    if (height_a >= 0) kept[count++] = a;
    if ((height_a > 0 && height_b < 0) || (height_a < 0 && height_b > 0))
      kept[count++] = point_at(a, b, axis, at);
  }
  corners_ = kept;
  count_ = static_cast<int>(count);
}

void ClippedPolygon::cut(const DoubleBox& box) {
  for (int axis = 0; axis < 3 && count_ > 0; ++axis) {
    cut(axis, box.lower[static_cast<size_t>(axis)], 1);
    cut(axis, box.upper[static_cast<size_t>(axis)], -1);
  }
}

bool are_apart(const TriangleMesh& mesh, const std::array<uint32_t, 3>& triangle, const DoubleBox& box) {
  const Double3 a = corner_of(mesh.vertices[triangle[0]]), b = corner_of(mesh.vertices[triangle[1]]),
                c = corner_of(mesh.vertices[triangle[2]]);
  for (size_t k = 0; k < 3; ++k) {
    if (std::max({a[k], b[k], c[k]}) < box.lower[k] || std::min({a[k], b[k], c[k]}) > box.upper[k])
      return true;
  }
  return false;
}

double volume_within(const TriangleMesh& mesh, const DoubleBox& box) {
  DoubleBox column = box;
  column.upper[0] = 1e30;  // in front of the box nothing counts
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    if (are_apart(mesh, t, column)) continue;
    ClippedPolygon inside(mesh, t);
    inside.cut(column);
    ClippedPolygon behind = inside;
    inside.cut(0, box.upper[0], -1);
    behind.cut(0, box.upper[0], 1);
    sum += flux(inside, box.lower[0]) + twice_area_along_x(behind) * (box.upper[0] - box.lower[0]);
  }
  return sum / 2;
}

}  // namespace meniscus::collision
