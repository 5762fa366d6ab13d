// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The contacts of hulls with planes, balls and capsules.
#pragma once

#include "collision/rigid_contact/hull_hull.h"
#include "collision/rigid_contact/round.h"

namespace meniscus::collision {

/// A hull, `a`, against a half-space: its lowest vertices. `scale` (m) is its least half extent.
MENISCUS_HD inline void touch_hull_plane(const Pose& a, const Polytope& hull, const Pose& plane, float scale,
                                         float reach, Manifold& out) {
  out.normal = rotate(plane.rotation, {0, 1, 0});
  const Vec3 n = rotate(conjugate(a.rotation), out.normal);
  const float offset = dot(out.normal, a.position - plane.position);
  const auto each = [&](const auto& visit) {
    for (uint32_t i = 0; i < hull.vertices.count; ++i) {
      const Vec3 v = hull.vertex(i);
      if (offset + dot(n, v) <= reach) visit(ContactCorner{v, offset + dot(n, v), i});
    }
  };
  pick_four(each, n, scale, [&](const ContactCorner& c) {
    out.add(to_world(a, c.at - 0.5f * c.distance * n), c.distance, c.feature);
  });
}

/// The point of a hull that is nearest to p, both in its frame; or of the nearest face, where p is inside.
struct NearestOnHull {
  Vec3 normal;     ///< unit, outwards
  float distance;  ///< m, negative inside
};

/// The point of a face that is nearest to p.
MENISCUS_HD inline Vec3 nearest_on_face(const Polytope& hull, uint32_t face, Vec3 p) {
  const Vec3 flat = p - hull.from_face(face, p) * hull.normal(face);
  Vec3 best = flat;
  float least = -1;
  for (uint32_t k = 0; k < hull.corner_count(face); ++k) {
    const Segment edge{hull.corner(face, k), hull.corner(face, k + 1)};
    if (dot(hull.side(face, k), flat - edge.from) <= 0) continue;
    const Vec3 q = edge.at(nearest_on(edge, flat));
    const float size = dot(q - flat, q - flat);
    if (least < 0 || size < least) {
      least = size;
      best = q;
    }
  }
  return best;
}

MENISCUS_HD inline NearestOnHull nearest_on_hull(const Polytope& hull, Vec3 p) {
  NearestOnHull inside{{0, 1, 0}, -1e30f}, outside{{0, 1, 0}, 1e30f};
  for (uint32_t f = 0; f < hull.faces.count; ++f) {
    const float distance = hull.from_face(f, p);
    if (distance > inside.distance) inside = {hull.normal(f), distance};
    if (distance <= 0) continue;
    const Vec3 way = p - nearest_on_face(hull, f, p);
    if (length(way) < outside.distance) outside = {normalized_or(way, hull.normal(f)), length(way)};
  }
  return inside.distance <= 0 ? inside : outside;
}

/// A ball, `a`, against a hull.
MENISCUS_HD inline void touch_hull_ball(Vec3 ball, float radius, const Pose& at, const Polytope& hull,
                                        float reach, uint32_t feature, Manifold& out) {
  const NearestOnHull nearest = nearest_on_hull(hull, to_local(at, ball));
  const float distance = nearest.distance - radius;
  if (distance > reach) return;
  out.normal = rotate(at.rotation, nearest.normal);
  out.add(ball - (radius + 0.5f * distance) * out.normal, distance, feature);
}

/// Where a segment is deepest in a hull or nearest to one of its edges, 0 to 1, in the hull's frame.
MENISCUS_HD inline float nearest_on_segment_to(const Segment& s, const Polytope& hull) {
  float from = 0, to = 1;
  for (uint32_t f = 0; f < hull.faces.count; ++f) {
    const float d = hull.from_face(f, s.from), e = hull.from_face(f, s.to);
    if (d > 0 && e > 0) from = 2;
    if (d > 0 && e <= 0) from = pbd::max(from, d / (d - e));
    if (e > 0 && d <= 0) to = pbd::min(to, d / (d - e));
  }
  if (from <= to) return 0.5f * (from + to);
  float best = 0, least = 1e30f;
  const Vec3 d = s.to - s.from;
  for (uint32_t i = 0; i < hull.edges.count; ++i) {
    const Segment edge{hull.vertex(hull.edges[i].from), hull.vertex(hull.edges[i].to)};
    const Vec3 e = edge.to - edge.from, r = s.from - edge.from;
    const float dd = dot(d, d), ee = dot(e, e), de = dot(d, e), denominator = dd * ee - de * de;
    float t = denominator > 0 ? pbd::clamp((de * dot(e, r) - ee * dot(d, r)) / denominator, 0, 1) : 0;
    t = nearest_on(s, edge.at(nearest_on(edge, s.at(t))));
    const Vec3 apart = s.at(t) - edge.at(nearest_on(edge, s.at(t)));
    if (dot(apart, apart) < least) {
      least = dot(apart, apart);
      best = t;
    }
  }
  return best;
}

/// The two ends of the stretch over which a capsule lies along a face, in the hull's frame.
MENISCUS_HD inline void touch_along_face(const Segment& s, float radius, const Pose& at, const Polytope& hull,
                                         uint32_t face, float reach, Manifold& out) {
  const hull_hull::ClippedEdge c = hull_hull::clip(s.from, s.to, hull, face);
  const Vec3 n = hull.normal(face);
  const auto note = [&](float t, uint32_t feature) {
    const Vec3 p = s.at(t);
    const float distance = hull.from_face(face, p) - radius;
    if (distance <= reach) out.add(to_world(at, p - (radius + 0.5f * distance) * n), distance, feature);
  };
  if (c.from > c.to) return;
  note(c.from, 1 | c.entry << 2);
  if (c.to > c.from) note(c.to, 2 | c.exit << 2);
}

/// A capsule, `a`, against a hull: along the face that it lies on, or where it is nearest.
MENISCUS_HD inline void touch_hull_capsule(const Segment& axis, float radius, const Pose& at,
                                           const Polytope& hull, float reach, Manifold& out) {
  const Segment local{to_local(at, axis.from), to_local(at, axis.to)};
  const float places[3] = {0, 1, nearest_on_segment_to(local, hull)};
  int best = 0;
  NearestOnHull nearest{{0, 1, 0}, 1e30f};
  for (int k = 0; k < 3; ++k) {
    const NearestOnHull here = nearest_on_hull(hull, local.at(places[k]));
    if (here.distance >= nearest.distance) continue;
    nearest = here;
    best = k;
  }
  if (nearest.distance - radius > reach) return;
  out.normal = rotate(at.rotation, nearest.normal);
  const uint32_t face = hull_hull::most_against(hull, -nearest.normal);
  if (dot(hull.normal(face), nearest.normal) > rigid_contact_tuning::same_normal)
    touch_along_face(local, radius, at, hull, face, reach, out);
  if (out.count == 0) touch_hull_ball(axis.at(places[best]), radius, at, hull, reach, 3, out);
}

/// Two parts, of which one is a hull. A plane may only be `b`.
MENISCUS_HD inline Manifold touch_hull(const HullTable& table, const Pose& a, const Convex& of_a,
                                       const Pose& b, const Convex& of_b, float reach) {
  Manifold out;
  const auto is_round = [](const Convex& part) {
    return part.kind == ConvexKind::sphere || part.kind == ConvexKind::capsule;
  };
  if (of_b.kind == ConvexKind::plane) {
    touch_hull_plane(a, table.of(of_a), b, least_component(of_a.size), reach, out);
  } else if (!is_round(of_a) && !is_round(of_b)) {
    const float scale = least_component(min(of_a.size, of_b.size));
    touch_hulls(a, table.of(of_a), b, table.of(of_b), scale, reach, out);
  } else {
    const bool turned = is_round(of_b);
    const Convex &part = turned ? of_b : of_a, &hull = turned ? of_a : of_b;
    const Pose& at = turned ? a : b;
    const Segment axis = axis_of(turned ? b : a, part);
    if (part.kind == ConvexKind::capsule)
      touch_hull_capsule(axis, part.size.x, at, table.of(hull), reach, out);
    else
      touch_hull_ball(axis.from, part.size.x, at, table.of(hull), reach, 0, out);
    if (turned) out.normal = -out.normal;
  }
  return out;
}

}  // namespace meniscus::collision
