// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Intersections and distances of queries, on the host.
#include "sdk/world/queries/geometry.h"

#include <algorithm>
#include <cmath>

namespace meniscus::queries {

std::optional<float> meet_ball(Vec3 from, Vec3 ray, Vec3 centre, float radius) {
  const Vec3 to_start = from - centre;
  const float radius2 = radius * radius, a = dot(ray, ray), b = dot(to_start, ray);
  if (dot(to_start, to_start) < radius2 || b >= 0) return {};
  // The distance by which the ray misses the centre. The formula b² − ac would subtract numbers far larger
  // than the result.
  const Vec3 miss = to_start - (b / a) * ray;
  const float inside2 = radius2 - dot(miss, miss);
  if (inside2 < 0) return {};
  const float t = -b / a - std::sqrt(inside2 / a);
  return t <= 1 ? std::optional(t) : std::nullopt;
}

std::optional<float> meet_triangle(Vec3 from, Vec3 ray, Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 ab = b - a, ac = c - a, p = cross(ray, ac);
  const float volume = dot(ab, p);
  if (volume == 0) return {};
  const Vec3 from_a = from - a, q = cross(from_a, ab);
  const float u = dot(from_a, p) / volume, v = dot(ray, q) / volume, t = dot(ac, q) / volume;
  const bool hits = u >= 0 && v >= 0 && u + v <= 1 && t >= 0 && t <= 1;
  return hits ? std::optional(t) : std::nullopt;
}

namespace {

/// With the side of the cylinder between a and b.
std::optional<float> meet_side(Vec3 from, Vec3 ray, Vec3 a, Vec3 b, float radius) {
  const Vec3 axis = normalized_or(b - a, {0, 1, 0}), start = from - a;
  const Vec3 across = ray - dot(ray, axis) * axis, off = start - dot(start, axis) * axis;
  const float aa = dot(across, across), ab = dot(off, across);
  if (aa == 0 || ab >= 0) return {};
  const Vec3 miss = off - (ab / aa) * across;
  const float inside2 = radius * radius - dot(miss, miss);
  if (inside2 < 0 || dot(off, off) < radius * radius) return {};
  const float t = -ab / aa - std::sqrt(inside2 / aa), along = dot(start + t * ray, axis);
  return t <= 1 && along >= 0 && along <= length(b - a) ? std::optional(t) : std::nullopt;
}

}  // namespace

std::optional<float> meet_segment(Vec3 from, Vec3 ray, Vec3 a, Vec3 b, float radius) {
  if (length(from - nearest_on_segment(from, a, b)) < radius) return {};
  std::optional<float> first;
  for (const std::optional<float> t : {meet_side(from, ray, a, b, radius), meet_ball(from, ray, a, radius),
                                       meet_ball(from, ray, b, radius)}) {
    if (t && (!first || *t < *first)) first = t;
  }
  return first;
}

Vec3 nearest_on_segment(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 ab = b - a;
  const float whole = dot(ab, ab);
  return whole > 0 ? a + std::clamp(dot(p - a, ab) / whole, 0.0f, 1.0f) * ab : a;
}

namespace {

/// Whether the triangle and the box are apart along an axis.
bool are_apart(Vec3 axis, Vec3 half, Vec3 a, Vec3 b, Vec3 c) {
  const float pa = dot(axis, a), pb = dot(axis, b), pc = dot(axis, c), reach = dot(abs(axis), half);
  return std::min({pa, pb, pc}) > reach || std::max({pa, pb, pc}) < -reach;
}

}  // namespace

bool overlaps_box(Vec3 half, Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, edges[] = {b - a, c - b, a - c};
  if (are_apart(cross(edges[0], edges[1]), half, a, b, c)) return false;
  for (const Vec3 axis : axes) {
    if (are_apart(axis, half, a, b, c)) return false;
    for (const Vec3 edge : edges) {
      if (are_apart(cross(axis, edge), half, a, b, c)) return false;
    }
  }
  return true;
}

/// The distance to a convex body is convex along a segment, so a golden section search finds the least.
bool comes_near_box(Vec3 half, Vec3 a, Vec3 b, float distance) {
  const auto beyond = [&](float t) {
    const Vec3 out = max(abs(a + t * (b - a)) - half, Vec3{0, 0, 0});
    return length(out);
  };
  constexpr float golden = 0.618034f;
  float low = 0, high = 1;
  for (int k = 0; k < 40; ++k) {
    const float left = high - golden * (high - low), right = low + golden * (high - low);
    beyond(left) <= beyond(right) ? high = right : low = left;
  }
  return std::min({beyond(0), beyond(1), beyond(0.5f * (low + high))}) <= distance;
}

}  // namespace meniscus::queries
