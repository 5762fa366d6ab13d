// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The distance of cloth from a solid over all of its faces, in double precision and independent of the
// product's code.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/bench/harness/cloth_solid_bench.h"

namespace meniscus::tests {

class ClothSolidDistance {
 public:
  ClothSolidDistance(const SolidSetup& solid, const Pose& pose) : solid_(solid), pose_(pose) {}

  /// The least signed distance of any point of the cloth, m, to a hundredth of a millimetre.
  double least(const cloth::ClothMesh& mesh, const std::vector<Vec3>& positions) const {
    std::vector<Point> local;
    double best = 1e30;
    for (Vec3 p : positions) {
      local.push_back(in_frame(p));
      best = std::min(best, distance(local.back()));
    }
    for (const auto& t : mesh.triangles) search(local[t[0]], local[t[1]], local[t[2]], 9, best);
    return best;
  }

 private:
  using Point = std::array<double, 3>;

  static Point mix(const Point& a, const Point& b) {
    return {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2])};
  }
  static double gap(const Point& a, const Point& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  }

  Point in_frame(Vec3 world) const {
    const Quat& q = pose_.rotation;
    const double n = std::sqrt(double{q.x} * q.x + double{q.y} * q.y + double{q.z} * q.z + double{q.w} * q.w);
    const double u[3] = {-q.x / n, -q.y / n, -q.z / n}, w = q.w / n;
    const double v[3] = {double{world.x} - pose_.position.x, double{world.y} - pose_.position.y,
                         double{world.z} - pose_.position.z};
    const double t[3] = {2 * (u[1] * v[2] - u[2] * v[1]), 2 * (u[2] * v[0] - u[0] * v[2]),
                         2 * (u[0] * v[1] - u[1] * v[0])};
    return {v[0] + w * t[0] + u[1] * t[2] - u[2] * t[1], v[1] + w * t[1] + u[2] * t[0] - u[0] * t[2],
            v[2] + w * t[2] + u[0] * t[1] - u[1] * t[0]};
  }

  double distance(const Point& q) const {
    const double x = solid_.size.x, y = solid_.size.y, z = solid_.size.z;
    if (solid_.kind == collision::ShapeKind::capsule)
      return std::hypot(q[0], q[1] - std::clamp(q[1], -y, y), q[2]) - x;
    if (solid_.kind == collision::ShapeKind::sphere) return std::hypot(q[0], q[1], q[2]) - x;
    const double a[3] = {std::abs(q[0]) - x, std::abs(q[1]) - y, std::abs(q[2]) - z};
    const double out = std::hypot(std::max(a[0], 0.0), std::max(a[1], 0.0), std::max(a[2], 0.0));
    return out > 0 ? out : std::max({a[0], a[1], a[2]});
  }

  /// Leaves out parts that, by their centre, cannot be nearer.
  void search(const Point& a, const Point& b, const Point& c, int depth, double& best) const {
    const Point middle{(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3, (a[2] + b[2] + c[2]) / 3};
    const double here = distance(middle);
    best = std::min(best, here);
    const double radius = std::max({gap(a, middle), gap(b, middle), gap(c, middle)});
    if (depth == 0 || here - radius > best - 1e-5) return;
    const Point ab = mix(a, b), bc = mix(b, c), ca = mix(c, a);
    search(a, ab, ca, depth - 1, best);
    search(ab, b, bc, depth - 1, best);
    search(ca, bc, c, depth - 1, best);
    search(ab, bc, ca, depth - 1, best);
  }

  const SolidSetup& solid_;
  Pose pose_;
};

}  // namespace meniscus::tests
