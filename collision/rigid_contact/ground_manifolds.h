// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Collects the points at which a part touches a ground in manifolds, each with one normal.
#pragma once

#include "collision/rigid_contact/manifold.h"
#include "collision/rigid_contact/tuning.h"

namespace meniscus::collision {

/// The contacts of a part with a ground have so many normals at most.
inline constexpr uint32_t most_ground_normals = 6;

class GroundManifolds {
 public:
  MENISCUS_HD uint32_t count() const { return count_; }
  MENISCUS_HD const Manifold& operator[](uint32_t i) const { return all_[i]; }

  /// Adds a point. Where there are too many normals, those of the furthest points go.
  MENISCUS_HD void add(Vec3 normal, const ManifoldPoint& point) {
    uint32_t at = 0;
    while (at < count_ && dot(all_[at].normal, normal) < rigid_contact_tuning::same_normal) ++at;
    if (at == count_ && count_ < most_ground_normals) {
      all_[count_++] = Manifold{normal, 0, {}};
    } else if (at == count_) {
      at = furthest();
      if (lowest(all_[at]) <= point.distance) return;
      all_[at] = Manifold{normal, 0, {}};
    }
    add_to(all_[at], point);
  }

 private:
  MENISCUS_HD static float lowest(const Manifold& m) {
    float least = 1e30f;
    for (uint32_t k = 0; k < m.count; ++k) least = pbd::min(least, m.points[k].distance);
    return least;
  }
  MENISCUS_HD uint32_t furthest() const {
    uint32_t worst = 0;
    for (uint32_t i = 1; i < count_; ++i)
      if (lowest(all_[i]) > lowest(all_[worst])) worst = i;
    return worst;
  }

  MENISCUS_HD static void add_to(Manifold& m, const ManifoldPoint& point) {
    for (uint32_t k = 0; k < m.count; ++k) {
      if (m.points[k].feature != point.feature) continue;
      if (point.distance < m.points[k].distance) m.points[k] = point;
      return;
    }
    if (m.count < most_manifold_points)
      m.points[m.count++] = point;
    else
      replace(m, point);
  }

  /// Of five points one goes, so that the others span the most area. The lowest one stays.
  MENISCUS_HD static void replace(Manifold& m, const ManifoldPoint& point) {
    uint32_t low = most_manifold_points;
    for (uint32_t k = 0; k < most_manifold_points; ++k) {
      const float before = low == most_manifold_points ? point.distance : m.points[low].distance;
      if (m.points[k].distance < before) low = k;
    }
    // Without one of the four, or without the new one.
    uint32_t gone = most_manifold_points;
    float most = low == most_manifold_points ? -1 : area(m, most_manifold_points, point);
    for (uint32_t k = 0; k < most_manifold_points; ++k) {
      const float without = k == low ? -1 : area(m, k, point);
      if (without <= most) continue;
      most = without;
      gone = k;
    }
    if (gone < most_manifold_points) m.points[gone] = point;
  }

  /// A measure of the area of the four points with point k replaced: the largest product of diagonals.
  MENISCUS_HD static float area(const Manifold& m, uint32_t k, const ManifoldPoint& point) {
    Vec3 p[most_manifold_points];
    for (uint32_t i = 0; i < most_manifold_points; ++i) p[i] = i == k ? point.position : m.points[i].position;
    const Vec3 x = cross(p[0] - p[1], p[2] - p[3]), y = cross(p[0] - p[2], p[1] - p[3]),
               z = cross(p[0] - p[3], p[1] - p[2]);
    return pbd::max(dot(x, x), pbd::max(dot(y, y), dot(z, z)));
  }

  Manifold all_[most_ground_normals];
  uint32_t count_ = 0;
};

}  // namespace meniscus::collision
