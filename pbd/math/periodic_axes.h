// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Axes along which space repeats itself, and the images of points across their seams.
#pragma once

#include <cmath>

#include "pbd/device/base/qualifiers.h"
#include "pbd/math/vec.h"

namespace meniscus::pbd {

/// Along each axis with an extent above 0, a point and the same point one extent further are one. The seam of
/// an axis is at its low end, which is also its high end. An extent must be at least four reaches of the
/// neighbour search. Then no particle meets its own image, or another particle twice.
struct PeriodicAxes {
  Vec3 low{0, 0, 0};     ///< m
  Vec3 extent{0, 0, 0};  ///< m; 0: the axis does not repeat itself

  MENISCUS_HD bool any() const { return extent.x > 0 || extent.y > 0 || extent.z > 0; }

  /// m, what takes p to its place between the ends of each axis, within rounding.
  MENISCUS_HD Vec3 wrap(Vec3 p) const {
    const auto along = [](float x, float from, float length) {
      return length > 0 ? -length * floorf((x - from) / length) : 0.0f;
    };
    return {along(p.x, low.x, extent.x), along(p.y, low.y, extent.y), along(p.z, low.z, extent.z)};
  }

  /// m, from p across each seam that is nearer than `reach`; 0 on the other axes. p must lie between the
  /// ends.
  MENISCUS_HD Vec3 across_seams(Vec3 p, float reach) const {
    const auto along = [&](float x, float from, float length) {
      if (!(length > 0)) return 0.0f;
      return x < from + reach ? length : x > from + length - reach ? -length : 0.0f;
    };
    return {along(p.x, low.x, extent.x), along(p.y, low.y, extent.y), along(p.z, low.z, extent.z)};
  }

  /// m, between two points at this difference, or between their nearest images.
  MENISCUS_HD Vec3 nearest(Vec3 difference) const {
    const auto along = [](float d, float length) { return length > 0 ? d - length * rintf(d / length) : d; };
    return {along(difference.x, extent.x), along(difference.y, extent.y), along(difference.z, extent.z)};
  }
};

/// The images of one point: across a seam, across an edge where two seams meet, and across a corner.
struct SeamImages {
  Vec3 across;  ///< see PeriodicAxes::across_seams

  MENISCUS_HD uint32_t count() const {
    return (1u << ((across.x != 0) + (across.y != 0) + (across.z != 0))) - 1;
  }
  /// m, from the point to image n.
  MENISCUS_HD Vec3 offset(uint32_t n) const {
    uint32_t axes = n + 1;  // bit k: along the k-th axis that has a seam nearby
    const auto take = [&](float whole) {
      if (whole == 0) return 0.0f;
      const bool taken = (axes & 1) != 0;
      axes >>= 1;
      return taken ? whole : 0.0f;
    };
    const float x = take(across.x), y = take(across.y), z = take(across.z);
    return {x, y, z};
  }
};

}  // namespace meniscus::pbd
