// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The contact of two hulls: separating axes, of edges only those pairs whose arcs cross on the Gauss map
// (Gregorius 2013). Then the face of one is clipped to the face of the other.
#pragma once

#include "collision/rigid_contact/hull.h"
#include "collision/rigid_contact/pick_four.h"

namespace meniscus::collision::hull_hull {

struct BestFace {
  float distance = -1e30f;  ///< m
  uint32_t face = 0;
};

struct BestEdges {
  float distance = -1e30f;  ///< m
  uint32_t a = 0, b = 0;
  Vec3 axis{0, 0, 0};  ///< unit, from a to b, in the frame of a
};

/// The face of `p` from which `q` is furthest.
MENISCUS_HD inline BestFace best_face(const Polytope& p, const Polytope& q, const Pose& q_in_p) {
  const Quat into_q = conjugate(q_in_p.rotation);
  BestFace best;
  for (uint32_t f = 0; f < p.faces.count; ++f) {
    const float distance = p.from_face(f, q_in_p.position) - q.furthest(rotate(into_q, -p.normal(f)));
    if (distance > best.distance) best = {distance, f};
  }
  return best;
}

/// Whether the arc between the normals a and b crosses that between c and d, on one hemisphere.
MENISCUS_HD inline bool arcs_cross(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const Vec3 ba = cross(b, a), dc = cross(d, c);
  const float cba = dot(c, ba), dba = dot(d, ba), adc = dot(a, dc), bdc = dot(b, dc);
  return cba * dba < 0 && adc * bdc < 0 && cba * bdc > 0;
}

MENISCUS_HD inline BestEdges best_edges(const Polytope& a, const Polytope& b, const Pose& b_in_a) {
  BestEdges best;
  for (uint32_t j = 0; j < b.edges.count; ++j) {
    const HullEdge f = b.edges[j];
    const Vec3 q = to_world(b_in_a, b.vertex(f.from)), e = to_world(b_in_a, b.vertex(f.to)) - q;
    const Vec3 c = -rotate(b_in_a.rotation, b.normal(f.left)),
               d = -rotate(b_in_a.rotation, b.normal(f.right));
    const float least = rigid_contact_tuning::parallel * length(e);
    for (uint32_t i = 0; i < a.edges.count; ++i) {
      const HullEdge g = a.edges[i];
      if (!arcs_cross(a.normal(g.left), a.normal(g.right), c, d)) continue;
      const Vec3 p = a.vertex(g.from), along = a.vertex(g.to) - p;
      Vec3 axis = cross(along, e);
      const float size = length(axis);
      if (size <= least * length(along)) continue;
      axis = axis / (dot(axis, a.normal(g.left) + a.normal(g.right)) < 0 ? -size : size);
      const float distance = dot(axis, q - p);
      if (distance > best.distance) best = {distance, i, j, axis};
    }
  }
  return best;
}

/// The part of an edge of a polygon that lies within the sides of another one.
struct ClippedEdge {
  float from = 0, to = 1;
  uint32_t entry = 0, exit = 0;  ///< number of the side plus 1; 0: not clipped
};

MENISCUS_HD inline ClippedEdge clip(Vec3 from, Vec3 to, const Polytope& reference, uint32_t face) {
  ClippedEdge out;
  for (uint32_t k = 0; k < reference.corner_count(face) && out.from <= out.to; ++k) {
    const Vec3 side = reference.side(face, k), corner = reference.corner(face, k);
    const float d = dot(side, from - corner), e = dot(side, to - corner);
    if (d > 0 && e > 0) return {1, 0, 0, 0};
    if (d > 0 && d / (d - e) > out.from) {
      out.from = d / (d - e);
      out.entry = k + 1;
    } else if (e > 0 && d / (d - e) < out.to) {
      out.to = d / (d - e);
      out.exit = k + 1;
    }
  }
  return out;
}

/// A face of the reference hull, and the face of the other one that looks most against it.
struct TwoFaces {
  Polytope reference, other;
  uint32_t face, incident;
  Pose other_in_reference;

  MENISCUS_HD Vec3 corner(uint32_t k) const {
    return to_world(other_in_reference, other.corner(incident, k));
  }
  MENISCUS_HD ContactCorner at(Vec3 p, uint32_t feature) const {
    return {p, reference.from_face(face, p), feature};
  }
  MENISCUS_HD uint32_t cut(uint32_t corner, uint32_t side, bool is_exit) const {
    return other.corner_number(incident, corner) | side << 8 | (is_exit ? 1u << 7 : 0u);
  }

  /// Calls visit() for the corners of the area that both faces share, within `reach`.
  template <class Visit>
  MENISCUS_HD void each_corner(float reach, const Visit& visit) const {
    const auto note = [&](const ContactCorner& c) {
      if (c.distance <= reach) visit(c);
    };
    for (uint32_t k = 0; k < other.corner_count(incident); ++k) {
      const Vec3 p = corner(k), way = corner(k + 1) - p;
      const ClippedEdge c = clip(p, p + way, reference, face);
      if (c.from > c.to) continue;
      note(at(p + c.from * way, cut(k, c.entry, false)));
      if (c.exit) note(at(p + c.to * way, cut(k, c.exit, true)));
    }
    each_covered_corner(note);
  }

  /// The corners of the reference face that the other one covers, as points of the other one.
  template <class Visit>
  MENISCUS_HD void each_covered_corner(const Visit& visit) const {
    const Vec3 n = reference.normal(face), m = rotate(other_in_reference.rotation, other.normal(incident));
    const float slope = dot(m, n);
    if (slope > -rigid_contact_tuning::parallel) return;
    for (uint32_t k = 0; k < reference.corner_count(face); ++k) {
      const Vec3 c = reference.corner(face, k);
      bool covered = true;
      for (uint32_t s = 0; s < other.corner_count(incident) && covered; ++s)
        covered = dot(cross(corner(s + 1) - corner(s), n), c - corner(s)) > 0;
      if (covered)
        visit(at(c + (dot(m, corner(0) - c) / slope) * n, reference.corner_number(face, k) | 1u << 15));
    }
  }
};

MENISCUS_HD inline uint32_t most_against(const Polytope& hull, Vec3 direction) {
  uint32_t face = 0;
  float least = 2;
  for (uint32_t f = 0; f < hull.faces.count; ++f) {
    const float along = dot(hull.normal(f), direction);
    if (along < least) {
      least = along;
      face = f;
    }
  }
  return face;
}

/// `code` tells faces of one hull from those of the other.
MENISCUS_HD inline void touch_faces(const Polytope& reference, uint32_t face, const Pose& at,
                                    const Polytope& other, const Pose& other_in_reference, uint32_t code,
                                    float scale, float reach, Manifold& out) {
  const Vec3 n = reference.normal(face);
  const uint32_t incident = most_against(other, rotate(conjugate(other_in_reference.rotation), n));
  const TwoFaces faces{reference, other, face, incident, other_in_reference};
  pick_four([&](const auto& visit) { faces.each_corner(reach, visit); }, n, scale,
            [&](const ContactCorner& c) {
              out.add(to_world(at, c.at - 0.5f * c.distance * n), c.distance, code | face << 16 | c.feature);
            });
}

MENISCUS_HD inline void touch_edges(const Polytope& a, const Pose& at, const Polytope& b, const Pose& b_in_a,
                                    const BestEdges& best, Manifold& out) {
  const HullEdge g = a.edges[best.a], f = b.edges[best.b];
  const Vec3 p = a.vertex(g.from), d = a.vertex(g.to) - p;
  const Vec3 q = to_world(b_in_a, b.vertex(f.from)), e = to_world(b_in_a, b.vertex(f.to)) - q, r = q - p;
  // The point of the first line that is nearest to the second.
  const float dd = dot(d, d), ee = dot(e, e), de = dot(d, e);
  const float along = (dot(r, d) * ee - de * dot(r, e)) / (dd * ee - de * de);
  out.normal = rotate(at.rotation, -best.axis);
  out.add(to_world(at, p + pbd::clamp(along, 0, 1) * d + 0.5f * best.distance * best.axis), best.distance,
          1u << 31 | best.a << 8 | best.b);
}

}  // namespace meniscus::collision::hull_hull

namespace meniscus::collision {

/// Finds up to four points at which two hulls are within `reach`. `scale` (m) is their least half extent.
MENISCUS_HD inline void touch_hulls(const Pose& a, const Polytope& of_a, const Pose& b, const Polytope& of_b,
                                    float scale, float reach, Manifold& out) {
  using namespace hull_hull;
  const Pose b_in_a = inverse(a) * b, a_in_b = inverse(b_in_a);
  const BestFace face_a = best_face(of_a, of_b, b_in_a);
  if (face_a.distance > reach) return;
  const BestFace face_b = best_face(of_b, of_a, a_in_b);
  if (face_b.distance > reach) return;
  const BestEdges edges = best_edges(of_a, of_b, b_in_a);
  if (edges.distance > reach) return;
  const float tolerance = rigid_contact_tuning::face_preference * scale;
  if (edges.distance > pbd::max(face_a.distance, face_b.distance) + tolerance)
    return touch_edges(of_a, a, of_b, b_in_a, edges, out);
  if (face_b.distance > face_a.distance + tolerance) {
    out.normal = rotate(b.rotation, of_b.normal(face_b.face));
    touch_faces(of_b, face_b.face, b, of_a, a_in_b, 1u << 30, scale, reach, out);
  } else {
    out.normal = -rotate(a.rotation, of_a.normal(face_a.face));
    touch_faces(of_a, face_a.face, a, of_b, b_in_a, 0, scale, reach, out);
  }
}

}  // namespace meniscus::collision
