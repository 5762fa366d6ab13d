// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The fraction of a disc that triangles cover.
#pragma once

#include <cmath>

#include "pbd/math/tangents.h"

namespace meniscus::collision {

namespace area_detail {

struct Flat {
  float x, y;
};
MENISCUS_HD inline float dot(Flat a, Flat b) {
  return a.x * b.x + a.y * b.y;
}
MENISCUS_HD inline float cross(Flat a, Flat b) {
  return a.x * b.y - a.y * b.x;
}
MENISCUS_HD inline Flat along(Flat a, Flat b, float t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}
MENISCUS_HD inline float sector(Flat a, Flat b, float radius2) {
  return 0.5f * radius2 * atan2f(cross(a, b), dot(a, b));
}

/// The signed area of the intersection of a disc about the origin with the triangle of the origin, a and b.
MENISCUS_HD inline float shared_with_disc(Flat a, Flat b, float radius2) {
  const Flat d{b.x - a.x, b.y - a.y};
  const float dd = dot(d, d), ad = dot(a, d), outside = dot(a, a) - radius2;
  const float root2 = ad * ad - dd * outside;
  if (!(dd > 0) || root2 <= 0) return sector(a, b, radius2);
  const float root = sqrtf(root2), enters = (-ad - root) / dd, leaves = (-ad + root) / dd;
  if (enters >= 1 || leaves <= 0) return sector(a, b, radius2);
  const Flat p = enters > 0 ? along(a, b, enters) : a, q = leaves < 1 ? along(a, b, leaves) : b;
  float area = 0.5f * cross(p, q);
  if (enters > 0) area += sector(a, p, radius2);
  if (leaves < 1) area += sector(q, b, radius2);
  return area;
}

}  // namespace area_detail

/// A disc about a point, orthogonal to a unit normal; m.
class Disc {
 public:
  MENISCUS_HD Disc(Vec3 centre, Vec3 normal, float radius)
      : centre_(centre), normal_(normal), tangents_(normal), radius2_(radius * radius) {}

  /// The fraction of the disc that the triangle covers, seen along the normal.
  MENISCUS_HD float covered(Vec3 a, Vec3 b, Vec3 c) const {
    using namespace area_detail;
    const Flat p = flat(a), q = flat(b), r = flat(c);
    const float area = shared_with_disc(p, q, radius2_) + shared_with_disc(q, r, radius2_) +
                       shared_with_disc(r, p, radius2_);
    return fabsf(area) / (3.14159265f * radius2_);
  }
  MENISCUS_HD Vec3 normal() const { return normal_; }

 private:
  MENISCUS_HD area_detail::Flat flat(Vec3 x) const {
    return {dot(tangents_.u, x - centre_), dot(tangents_.v, x - centre_)};
  }

  Vec3 centre_, normal_;
  Tangents tangents_;
  float radius2_;
};

}  // namespace meniscus::collision
