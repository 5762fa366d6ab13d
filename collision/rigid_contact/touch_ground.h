// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The contacts of a part with a ground, in the ground's frame: of points of the part with the surface, and of
// sharp edges of the surface with the part.
#pragma once

#include "collision/rigid_contact/ground_manifolds.h"
#include "collision/rigid_contact/ground_point.h"
#include "collision/rigid_contact/hull_round.h"

namespace meniscus::collision::touch_ground_parts {

/// What a contact with a ground is found from.
struct Search {
  const Ground& ground;
  float reach;  ///< m: how far apart a contact may be
  float depth;  ///< m: how deep points are found
  float slack;  ///< m: less is rounding
  GroundManifolds& out;
};

/// Numbers of features: of a part's points, with the side to which the surface faces.
MENISCUS_HD inline uint32_t point_feature(uint32_t point, Vec3 n) {
  const Vec3 size = abs(n);
  const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  return point << 3 | static_cast<uint32_t>(axis) << 1 | (component(n, axis) < 0 ? 1u : 0u);
}

/// A ball of the part, or a vertex of it.
template <class Allowed>
MENISCUS_HD void touch_at(const Search& s, Vec3 p, float radius, uint32_t point, const Allowed& allowed) {
  const TouchRange range{s.reach + radius, s.depth + radius, s.slack};
  each_touch(s.ground, p, range, allowed, [&](const GroundTouch& touch) {
    const float distance = touch.distance - radius;
    s.out.add(touch.normal,
              {p - (radius + 0.5f * distance) * touch.normal, distance, point_feature(point, touch.normal)});
  });
}

MENISCUS_HD inline void touch_ball(const Search& s, Vec3 p, float radius, uint32_t point) {
  touch_at(s, p, radius, point, [](Vec3) { return true; });
}

/// A vertex touches what the part does not extend into. So a box that is flush with a side of the ground, and
/// stands on its top, is not held by that side.
MENISCUS_HD inline void touch_vertex(const Search& s, const Pose& at, const Polytope& part, uint32_t i) {
  const Vec3 v = part.vertex(i);
  const auto allowed = [&](Vec3 normal) {
    const Vec3 n = rotate(conjugate(at.rotation), normal);
    for (uint32_t k = 0; k < part.vertices.count; ++k) {
      const Vec3 way = part.vertex(k) - v;
      if (dot(way, n) < -rigid_contact_tuning::facing * length(way)) return false;
    }
    return true;
  };
  touch_at(s, to_world(at, v), 0, i, allowed);
}

/// A sharp edge of the surface.
struct SharpEdge {
  Vec3 from, to;
  Vec3 left, right;  ///< normals beside it
  uint32_t number;

  MENISCUS_HD uint32_t feature(uint32_t kind, uint32_t which) const {
    return 1u << 31 | kind << 29 | (number & 0x1fffff) << 8 | (which & 0xff);
  }
  /// Whether the solid falls off from the edge against a unit direction across it.
  MENISCUS_HD bool is_top(Vec3 n) const {
    const Vec3 e = to - from;
    const float size = length(e), slack = rigid_contact_tuning::parallel * size;
    return fabsf(dot(n, e)) < rigid_contact_tuning::same_normal * size && dot(n, cross(left, e)) <= slack &&
           dot(n, cross(e, right)) <= slack;
  }
};

/// Calls visit() for the sharp edges near a box.
template <class Visit>
MENISCUS_HD void each_edge(const Ground& ground, Vec3 middle, Vec3 half, float reach, const Visit& visit) {
  ground.each_near(middle, half, reach, [&](uint32_t i) {
    const Triangle& t = ground.triangles[i];
    const TriangleSeams& s = ground.seams[i];
    const Vec3 corner[3] = {t.a, t.b, t.c}, n = normalized_or(area_normal(t), {0, 1, 0});
    for (int k = 0; k < 3; ++k)
      if (s.edge[k] != no_edge)
        visit(SharpEdge{corner[k], corner[k == 2 ? 0 : k + 1], n, s.beside[k], s.edge[k]});
  });
}

/// An edge over a face of the part.
struct OverFace {
  uint32_t face;
  hull_hull::ClippedEdge stretch;
  float lowest;  ///< m, of the distances at its ends
};

/// Of the faces which the edge may bear, that of the least depth.
MENISCUS_HD inline OverFace best_over(const SharpEdge& edge, const Segment& local, const Pose& at,
                                      const Polytope& part) {
  OverFace best{no_edge, {}, -1e30f};
  for (uint32_t f = 0; f < part.faces.count; ++f) {
    if (!edge.is_top(-rotate(at.rotation, part.normal(f)))) continue;
    const hull_hull::ClippedEdge c = hull_hull::clip(local.from, local.to, part, f);
    if (c.from > c.to) continue;
    const float lowest = pbd::min(part.from_face(f, local.at(c.from)), part.from_face(f, local.at(c.to)));
    if (lowest > best.lowest) best = {f, c, lowest};
  }
  return best;
}

/// The stretch of an edge that lies over a face of the part.
MENISCUS_HD inline void touch_face(const Search& s, const SharpEdge& edge, const Pose& at,
                                   const Polytope& part) {
  const Segment local{to_local(at, edge.from), to_local(at, edge.to)};
  const OverFace over = best_over(edge, local, at, part);
  if (over.face == no_edge || over.lowest < -s.depth) return;
  const Vec3 n = -rotate(at.rotation, part.normal(over.face));
  const auto note = [&](float t, uint32_t which) {
    const float distance = part.from_face(over.face, local.at(t));
    if (distance > s.reach) return;
    const Vec3 p = edge.from + t * (edge.to - edge.from);
    s.out.add(n, {p + 0.5f * distance * n, distance, edge.feature(0, which)});
  };
  note(over.stretch.from, 0);
  note(over.stretch.to, 1);
}

/// Edges of the part that cross the edge (see best_edges).
MENISCUS_HD inline void touch_part_edges(const Search& s, const SharpEdge& edge, const Pose& at,
                                         const Polytope& part) {
  const Vec3 p = to_local(at, edge.from), e = to_local(at, edge.to) - p;
  const Quat into = conjugate(at.rotation);
  const Vec3 c = -rotate(into, edge.left), d = -rotate(into, edge.right);
  for (uint32_t i = 0; i < part.edges.count; ++i) {
    const HullEdge g = part.edges[i];
    if (!hull_hull::arcs_cross(part.normal(g.left), part.normal(g.right), c, d)) continue;
    const Vec3 q = part.vertex(g.from), f = part.vertex(g.to) - q;
    Vec3 axis = cross(f, e);
    const float size = length(axis);
    if (size <= rigid_contact_tuning::parallel * length(e) * length(f)) continue;
    axis = axis / (dot(axis, part.normal(g.left) + part.normal(g.right)) < 0 ? -size : size);
    const float distance = dot(axis, p - q);
    if (distance > s.reach || distance < -s.depth) continue;
    const float ee = dot(e, e), ff = dot(f, f), ef = dot(e, f), whole = ee * ff - ef * ef;
    const Vec3 r = q - p;
    const float along = (dot(r, e) * ff - ef * dot(r, f)) / whole,
                across = (ef * dot(r, e) - ee * dot(r, f)) / whole;
    if (along < 0 || along > 1 || across < 0 || across > 1) continue;
    const Vec3 n = -rotate(at.rotation, axis);
    s.out.add(n, {to_world(at, p + along * e) + 0.5f * distance * n, distance, edge.feature(1, i)});
  }
}

MENISCUS_HD inline void touch_polytope(const Search& s, const Pose& at, const Polytope& part, Vec3 half) {
  for (uint32_t i = 0; i < part.vertices.count; ++i) touch_vertex(s, at, part, i);
  each_edge(s.ground, at.position, half, s.reach, [&](const SharpEdge& edge) {
    touch_face(s, edge, at, part);
    if (!(edge.right == Vec3{0, 0, 0})) touch_part_edges(s, edge, at, part);
  });
}

/// The middle of a capsule on an edge.
MENISCUS_HD inline void touch_middle(const Search& s, const SharpEdge& edge, const Segment& axis,
                                     float radius) {
  const Segment other{edge.from, edge.to};
  const Vec3 d = axis.to - axis.from, e = edge.to - edge.from, r = axis.from - edge.from;
  const float dd = dot(d, d), ee = dot(e, e), de = dot(d, e), whole = dd * ee - de * de;
  if (whole <= rigid_contact_tuning::parallel * dd * ee) return;
  const float t = (de * dot(e, r) - ee * dot(d, r)) / whole;
  if (t < 0 || t > 1) return;
  const Vec3 p = axis.at(t), way = p - other.at(nearest_on(other, p));
  const float distance = length(way) - radius;
  const Vec3 n = normalized_or(way, normalized_or(edge.left + edge.right, {0, 1, 0}));
  if (distance > s.reach || !edge.is_top(n)) return;
  s.out.add(n, {p - (radius + 0.5f * distance) * n, distance, edge.feature(2, 0)});
}

MENISCUS_HD inline void touch_capsule(const Search& s, const Pose& at, const Convex& part, Vec3 half) {
  const Segment axis = axis_of(at, part);
  touch_ball(s, axis.from, part.size.x, 1);
  touch_ball(s, axis.to, part.size.x, 2);
  each_edge(s.ground, at.position, half, s.reach,
            [&](const SharpEdge& edge) { touch_middle(s, edge, axis, part.size.x); });
}

}  // namespace meniscus::collision::touch_ground_parts

namespace meniscus::collision {

/// Finds where a part touches a ground, within `reach`, and no deeper than its middle. `half` is that of the
/// box around the part, along the axes of the ground. Normals and positions are in the ground's frame.
MENISCUS_HD inline void touch_ground(const HullTable& hulls, const Pose& at, const Convex& part, Vec3 half,
                                     const Ground& ground, float reach, GroundManifolds& out) {
  using namespace touch_ground_parts;
  const bool is_round = part.kind == ConvexKind::sphere || part.kind == ConvexKind::capsule;
  const float depth = is_round ? part.size.x : least_component(part.size);
  const float slack = rigid_contact_tuning::level * bounding_radius(part);
  const Search s{ground, reach, depth, slack, out};
  if (part.kind == ConvexKind::sphere)
    touch_ball(s, at.position, part.size.x, 0);
  else if (part.kind == ConvexKind::capsule)
    touch_capsule(s, at, part, half);
  else
    touch_polytope(s, at, hulls.of(part), half);
}

}  // namespace meniscus::collision
