// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Functions of a triangle and a point: the nearest point, and the solid angle.
#pragma once

#include "pbd/math/vec.h"

namespace meniscus::collision {

struct Triangle {
  Vec3 a, b, c;  ///< counter-clockwise as seen from outside
};

MENISCUS_HD inline float squared_length(Vec3 a) {
  return dot(a, a);
}

/// Normal of the triangle; its length is twice the area.
MENISCUS_HD inline Vec3 area_normal(const Triangle& t) {
  return cross(t.b - t.a, t.c - t.a);
}

/// The point of the segment from a to b that is nearest to the origin.
MENISCUS_HD inline Vec3 nearest_on_segment(Vec3 a, Vec3 b) {
  const Vec3 ab = b - a;
  const float along = -dot(ab, a), whole = dot(ab, ab);
  if (along <= 0) return a;
  return along < whole ? a + (along / whole) * ab : b;
}

/// The point of triangle t that is nearest to p, less p. One plane per edge separates the regions, and not
/// products of two such tests (Ericson, Real-Time Collision Detection, 5.1.5). In float the products lose all
/// digits for a triangle that is small relative to its distance.
MENISCUS_HD inline Vec3 offset_to_triangle(const Triangle& t, Vec3 p) {
  const Vec3 a = t.a - p, b = t.b - p, c = t.c - p;
  const Vec3 n = cross(b - a, c - a);
  const float nn = squared_length(n);
  const bool past_ab = dot(cross(b - a, n), a) < 0;
  const bool past_bc = dot(cross(c - b, n), b) < 0;
  const bool past_ca = dot(cross(a - c, n), c) < 0;
  if (!past_ab && !past_bc && !past_ca && nn > 0) return (dot(n, a) / nn) * n;

  // The nearest point lies on an edge whose plane p is beyond. For a triangle without area all three edges
  // are tried.
  Vec3 nearest = a;
  const bool flat = !(nn > 0);
  if (past_ab || flat) nearest = nearest_on_segment(a, b);
  if (past_bc || flat) {
    const Vec3 other = nearest_on_segment(b, c);
    if ((!past_ab && !flat) || squared_length(other) < squared_length(nearest)) nearest = other;
  }
  if (past_ca || flat) {
    const Vec3 other = nearest_on_segment(c, a);
    if ((!past_ab && !past_bc && !flat) || squared_length(other) < squared_length(nearest)) nearest = other;
  }
  return nearest;
}

/// The fraction of the sphere around p that the triangle covers, 1 for all of it. Positive where p sees the
/// back, as it does from inside. Van Oosterom and Strackee 1983.
MENISCUS_HD inline float covered_fraction(const Triangle& t, Vec3 p) {
  const Vec3 a = t.a - p, b = t.b - p, c = t.c - p;
  const float la = length(a), lb = length(b), lc = length(c);
  const float volume = dot(a, cross(b, c));
  const float denominator = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
  constexpr float inverse_2pi = 0.15915494309189535f;
  return inverse_2pi * atan2f(volume, denominator);
}

}  // namespace meniscus::collision
