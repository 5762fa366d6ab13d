// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Nearest points of a vertex and a triangle, or of two edges, that move along straight lines; and the time at
// which they meet.
#pragma once

#include <cstdint>

#include "pbd/device/base/qualifiers.h"
#include "pbd/math/vec.h"
#include "pbd/tuning.h"

namespace meniscus::pbd {

/// Four vertices: a vertex and the three corners of a triangle, or the ends of two edges.
struct FeaturePair {
  Vec3 start[4];   ///< m, relative to a nearby origin
  Vec3 motion[4];  ///< m
  bool edges = false;

  MENISCUS_HD Vec3 at(int corner, float t) const { return start[corner] + t * motion[corner]; }
};

/// The nearest points of a pair: r = Σ weight · corner, from the triangle, or the second edge, to the other
/// feature.
struct Nearest {
  Vec3 r;          ///< m
  float distance;  ///< m, |r|
  float u, v;   ///< weights of the triangle's second and third corner; or positions along the first and the
                ///< second edge
  uint32_t on;  ///< bit k: corner k has a weight (of a vertex and a triangle: of the triangle's corners)
};

/// The weights of the four corners in r.
MENISCUS_HD inline void corner_weights(bool edges, float u, float v, float (&weight)[4]) {
  weight[0] = edges ? 1 - u : 1;
  weight[1] = edges ? u : u + v - 1;
  weight[2] = edges ? v - 1 : -u;
  weight[3] = -v;
}

namespace nearest_detail {

/// Where the segment from a to b is nearest to the origin, 0 at a to 1 at b.
MENISCUS_HD inline float along_segment(Vec3 a, Vec3 b) {
  const Vec3 ab = b - a;
  const float along = -dot(ab, a), whole = dot(ab, ab);
  return along <= 0 ? 0 : along < whole ? along / whole : 1;
}

/// Updates the nearest point if the edge from corner k of the triangle is nearer.
MENISCUS_HD inline void try_edge(const Vec3 (&corner)[3], uint32_t k, Nearest& best, float& best2) {
  const uint32_t next = k < 2 ? k + 1 : 0;
  const float t = along_segment(corner[k], corner[next]);
  const Vec3 nearest = corner[k] + t * (corner[next] - corner[k]);
  const float d2 = dot(nearest, nearest);
  if (d2 >= best2) return;
  best2 = d2;
  float weight[3] = {0, 0, 0};
  weight[k] = 1 - t;
  weight[next] = t;
  best = {-nearest, 0, weight[1], weight[2], (t < 1 ? 1u << k : 0u) | (t > 0 ? 1u << next : 0u)};
}

}  // namespace nearest_detail

/// Whether a point is on the inner side of all edges of a triangle, seen along its normal. Then its nearest
/// point is not on an edge.
MENISCUS_HD inline bool is_over_triangle(Vec3 p, Vec3 t0, Vec3 t1, Vec3 t2) {
  const Vec3 n = cross(t1 - t0, t2 - t0), a = t0 - p, b = t1 - p, c = t2 - p;
  return dot(cross(b - a, n), a) >= 0 && dot(cross(c - b, n), b) >= 0 && dot(cross(a - c, n), c) >= 0;
}

/// The point of a triangle nearest to p. A plane for each edge separates the regions, which is robust for
/// slivers in float.
MENISCUS_HD inline Nearest nearest_on_triangle(Vec3 p, Vec3 t0, Vec3 t1, Vec3 t2) {
  const Vec3 corner[3] = {t0 - p, t1 - p, t2 - p};
  const Vec3 n = cross(corner[1] - corner[0], corner[2] - corner[0]);
  const float nn = dot(n, n);
  bool past[3], inside = nn > 0;
  MENISCUS_UNROLL
  for (uint32_t k = 0; k < 3; ++k) {
    const Vec3 a = corner[k], b = corner[k < 2 ? k + 1 : 0];
    past[k] = dot(cross(b - a, n), a) < 0;
    inside = inside && !past[k];
  }
  Nearest best{{0, 0, 0}, 0, 0, 0, 7};
  if (inside) {
    best.u = dot(cross(corner[2], corner[0]), n) / nn;
    best.v = dot(cross(corner[0], corner[1]), n) / nn;
    best.r = (-dot(n, corner[0]) / nn) * n;
  } else {
    // The nearest point is on an edge whose outer side has p. For a triangle without area all three are
    // tried.
    float best2 = 3e38f;
    MENISCUS_UNROLL
    for (uint32_t k = 0; k < 3; ++k)
      if (past[k] || !(nn > 0)) nearest_detail::try_edge(corner, k, best, best2);
    if (best2 > 1e38f) {
      MENISCUS_UNROLL
      for (uint32_t k = 0; k < 3; ++k) nearest_detail::try_edge(corner, k, best, best2);
    }
  }
  best.distance = length(best.r);
  return best;
}

/// The nearest points of the edges from a to b and from c to d: both inside the edges, or one at an end.
MENISCUS_HD inline Nearest nearest_of_edges(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const Vec3 e = b - a, f = d - c, r = a - c;
  const Vec3 n = cross(e, f);
  const float nn = dot(n, n);
  if (nn > 1e-10f * dot(e, e) * dot(f, f)) {
    const float u = dot(cross(f, r), n) / nn, v = dot(cross(e, r), n) / nn;
    if (u > 0 && u < 1 && v > 0 && v < 1) {
      const Vec3 across = (dot(n, r) / nn) * n;
      return {across, length(across), u, v, 15};
    }
  }
  Nearest best{};
  float best2 = 3e38f;
  const auto consider = [&](float u, float v) {
    const Vec3 displacement = r + u * e - v * f;
    const float d2 = dot(displacement, displacement);
    if (d2 >= best2) return;
    best2 = d2;
    best = {displacement, 0, u, v,
            (u < 1 ? 1u : 0u) | (u > 0 ? 2u : 0u) | (v < 1 ? 4u : 0u) | (v > 0 ? 8u : 0u)};
  };
  consider(0, nearest_detail::along_segment(c - a, d - a));
  consider(1, nearest_detail::along_segment(c - b, d - b));
  consider(nearest_detail::along_segment(a - c, b - c), 0);
  consider(nearest_detail::along_segment(a - d, b - d), 1);
  best.distance = length(best.r);
  return best;
}

MENISCUS_HD inline Nearest nearest(const FeaturePair& p, float t) {
  if (p.edges) return nearest_of_edges(p.at(0, t), p.at(1, t), p.at(2, t), p.at(3, t));
  return nearest_on_triangle(p.at(0, t), p.at(1, t), p.at(2, t), p.at(3, t));
}

/// For a vertex and a triangle, at time t.
MENISCUS_HD inline bool is_over_triangle(const FeaturePair& p, float t) {
  return is_over_triangle(p.at(0, t), p.at(1, t), p.at(2, t), p.at(3, t));
}

/// Calls visit(a, b) for each corner a of one feature with each corner b of the other.
template <class Visit>
MENISCUS_HD void for_each_across(const FeaturePair& p, const Visit& visit) {
  visit(0, 2);
  visit(0, 3);
  if (!p.edges) return visit(0, 1);
  visit(1, 2);
  visit(1, 3);
}

/// m, the greatest relative motion of any two points of the two features.
MENISCUS_HD inline float relative_motion(const FeaturePair& p) {
  float most2 = 0;
  for_each_across(p, [&](int a, int b) {
    const Vec3 d = p.motion[a] - p.motion[b];
    most2 = pbd::max(most2, dot(d, d));
  });
  return sqrtf(most2);
}

/// m, a lower bound: along some axis the two stay this far apart during the whole motion. Between the start
/// and the end, the gap along an axis is no less than at both, as limits of steady motions are concave. A
/// motion that both share changes nothing.
MENISCUS_HD inline float least_gap(const FeaturePair& p) {
  Vec3 below[2], above[2];  // the first feature's gap to the second on either side, at the start and the end
  MENISCUS_UNROLL
  for (int end = 0; end < 2; ++end) {
    Vec3 x[4];
    MENISCUS_UNROLL
    for (int k = 0; k < 4; ++k) x[k] = end ? p.at(k, 1) : p.start[k];
    const Vec3 low = p.edges ? min(x[0], x[1]) : x[0], high = p.edges ? max(x[0], x[1]) : x[0];
    Vec3 other_low = min(x[2], x[3]), other_high = max(x[2], x[3]);
    if (!p.edges) {
      other_low = min(other_low, x[1]);
      other_high = max(other_high, x[1]);
    }
    below[end] = other_low - high;
    above[end] = low - other_high;
  }
  return max_component(max(min(below[0], below[1]), min(above[0], above[1])));
}

namespace nearest_detail {

/// How much later than t, at the earliest, the two may be as near as `gap`. Along the direction that
/// separates them, every corner of one is at least this far from every corner of the other. Each pair of
/// corners approaches at a constant speed.
MENISCUS_HD inline float time_apart(const FeaturePair& p, const Nearest& now, float t, float gap) {
  const Vec3 away = now.r / now.distance;
  float time = 2;
  for_each_across(p, [&](int a, int b) {
    const float approach = dot(away, p.motion[b] - p.motion[a]);
    if (!(approach > 0)) return;
    const float apart = pbd::max(now.distance, dot(away, p.at(a, t) - p.at(b, t)));
    time = pbd::min(time, (apart - gap) / approach);
  });
  return time;
}

}  // namespace nearest_detail

/// The fraction of the motion, 0 to 1, after which the two are as near as `gap`, and no nearer than
/// `nearest_stop` of it; 2 where they never are. At the start they must be further apart. Conservative
/// advancement with bounds along the direction that separates them (Mirtich 1996; Tang, Kim & Manocha 2009).
/// Each step is as long as the bounds allow, and no root can be missed.
MENISCUS_HD inline float time_of_nearness(const FeaturePair& p, float gap) {
  float t = 0;
  Nearest now = nearest(p, 0);
  for (int k = 0; k < nearness_tuning::most_steps; ++k) {
    t += nearest_detail::time_apart(p, now, t, nearness_tuning::nearest_stop * gap);
    if (t >= 1) return 2;
    now = nearest(p, t);
    if (now.distance <= gap) return t;
  }
  return t;  // they graze: the motion stops here
}

}  // namespace meniscus::pbd
