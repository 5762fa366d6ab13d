// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The contact of two boxes: separating axes, then the face of one is clipped to the face of the other
// (Gottschalk, Lin & Manocha 1996; Sutherland & Hodgman 1974).
#pragma once

#include "collision/rigid_contact/manifold.h"
#include "collision/rigid_contact/tuning.h"

namespace meniscus::collision::box_box {

/// The axes of b in the frame of a, the centre of b there, and the distance along the best axis so far.
struct Axes {
  Vec3 half_a, half_b, centre;
  Vec3 b[3];
};

/// A candidate axis: 0 to 2 are faces of a, 3 to 5 faces of b, 6 to 14 pairs of edges.
struct Best {
  float distance = -1e30f;
  int axis = -1;
};

MENISCUS_HD inline Axes axes_of(const Pose& a, Vec3 half_a, const Pose& b, Vec3 half_b) {
  const Quat turn = conjugate(a.rotation) * b.rotation;
  return {half_a,
          half_b,
          to_local(a, b.position),
          {rotate(turn, {1, 0, 0}), rotate(turn, {0, 1, 0}), rotate(turn, {0, 0, 1})}};
}

MENISCUS_HD inline float reach_of_b(const Axes& x, Vec3 direction) {
  return x.half_b.x * fabsf(dot(x.b[0], direction)) + x.half_b.y * fabsf(dot(x.b[1], direction)) +
         x.half_b.z * fabsf(dot(x.b[2], direction));
}

MENISCUS_HD inline float face_distance(const Axes& x, int axis) {
  if (axis < 3) {
    const Vec3 n = unit_axis(axis);
    return fabsf(dot(x.centre, n)) - dot(x.half_a, n) - reach_of_b(x, n);
  }
  const Vec3 n = x.b[axis - 3];
  return fabsf(dot(x.centre, n)) - component(x.half_b, axis - 3) - dot(x.half_a, abs(n));
}

/// The unit direction of a pair of edges, or zero where they are parallel.
MENISCUS_HD inline Vec3 edge_axis(const Axes& x, int of_a, int of_b) {
  const Vec3 n = cross(unit_axis(of_a), x.b[of_b]);
  const float size = length(n);
  return size > rigid_contact_tuning::parallel ? n / size : Vec3{0, 0, 0};
}

MENISCUS_HD inline Best best_face(const Axes& x, float tolerance) {
  Best best;
  for (int axis = 0; axis < 6; ++axis) {
    const float distance = face_distance(x, axis);
    if (distance > best.distance + (best.axis < 0 ? 0 : tolerance)) best = {distance, axis};
  }
  return best;
}

MENISCUS_HD inline Best best_edges(const Axes& x) {
  Best best;
  for (int k = 0; k < 9; ++k) {
    const Vec3 n = edge_axis(x, k / 3, k % 3);
    if (n == Vec3{0, 0, 0}) continue;
    const float distance = fabsf(dot(x.centre, n)) - dot(x.half_a, abs(n)) - reach_of_b(x, n);
    if (distance > best.distance) best = {distance, 6 + k};
  }
  return best;
}

/// A corner of the clipped face, in the frame of the reference box.
struct Corner {
  Vec3 at;
  uint32_t feature;
};

/// Room for a quadrilateral that four planes have clipped.
struct Polygon {
  Corner corners[8];
  uint32_t count = 0;

  MENISCUS_HD void add(Vec3 at, uint32_t feature) {
    if (count < 8) corners[count++] = {at, feature};
  }
};

/// Keeps what is below `limit` along sign · axis.
MENISCUS_HD inline Polygon clipped(const Polygon& from, int axis, float sign, float limit, uint32_t plane) {
  Polygon to;
  for (uint32_t k = 0; k < from.count; ++k) {
    const Corner &here = from.corners[k], &next = from.corners[k + 1 < from.count ? k + 1 : 0];
    const float d = sign * component(here.at, axis) - limit, e = sign * component(next.at, axis) - limit;
    if (d <= 0) to.add(here.at, here.feature);
    if ((d <= 0) == (e <= 0)) continue;
    // An edge that is cut once more keeps the number of its first corner.
    to.add(here.at + (d / (d - e)) * (next.at - here.at), (here.feature & 3) | plane << 2 | (d <= 0) << 5);
  }
  return to;
}

/// The reference box with its face along an axis, and the other box in its frame.
struct Faces {
  Vec3 half, other_half, other_centre;
  Vec3 other[3];
  int axis;
  float sign;  ///< of the face's normal, towards the other box
};

/// The face of the other box that looks most against the reference face.
MENISCUS_HD inline Polygon incident_face(const Faces& f) {
  int axis = 0;
  float most = -1;
  for (int k = 0; k < 3; ++k) {
    const float along = fabsf(component(f.other[k], f.axis));
    if (along > most) {
      most = along;
      axis = k;
    }
  }
  const float side = f.sign * component(f.other[axis], f.axis) > 0 ? -1.0f : 1.0f;
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const Vec3 centre = f.other_centre + side * component(f.other_half, axis) * f.other[axis];
  const Vec3 along_u = component(f.other_half, u) * f.other[u];
  const Vec3 along_v = component(f.other_half, v) * f.other[v];
  Polygon face;
  face.add(centre + along_u + along_v, 0);
  face.add(centre - along_u + along_v, 1);
  face.add(centre - along_u - along_v, 2);
  face.add(centre + along_u - along_v, 3);
  return face;
}

/// The corner that is furthest by `measure`; equal ones in their order.
template <class Measure>
MENISCUS_HD uint32_t furthest(const Polygon& p, const Measure& measure) {
  uint32_t best = 0;
  float most = measure(p.corners[0].at);
  for (uint32_t k = 1; k < p.count; ++k) {
    const float value = measure(p.corners[k].at);
    if (value > most) {
      most = value;
      best = k;
    }
  }
  return best;
}

/// Keeps four corners: the deepest, the furthest from it, and those that span the most area to both sides.
MENISCUS_HD inline Polygon reduced(const Polygon& p, const Faces& f) {
  if (p.count <= most_manifold_points) return p;
  const Vec3 n = f.sign * unit_axis(f.axis);
  const uint32_t first = furthest(p, [&](Vec3 at) { return -dot(at, n); });
  const Vec3 a = p.corners[first].at;
  const uint32_t second = furthest(p, [&](Vec3 at) { return dot(at - a, at - a); });
  const Vec3 side = cross(n, p.corners[second].at - a);
  const uint32_t third = furthest(p, [&](Vec3 at) { return dot(side, at - a); });
  const uint32_t fourth = furthest(p, [&](Vec3 at) { return -dot(side, at - a); });
  Polygon kept;
  for (uint32_t k = 0; k < p.count; ++k) {
    if (k == first || k == second || k == third || k == fourth)
      kept.add(p.corners[k].at, p.corners[k].feature);
  }
  return kept;
}

MENISCUS_HD inline Faces faces_of(const Axes& x, int axis) {
  Faces f;
  if (axis < 3) {
    f = {x.half_a, x.half_b, x.centre, {x.b[0], x.b[1], x.b[2]}, axis, 0};
  } else {
    // The transposed rotation gives the axes of a in the frame of b.
    f = {x.half_b, x.half_a, {}, {}, axis - 3, 0};
    f.other_centre = -Vec3{dot(x.b[0], x.centre), dot(x.b[1], x.centre), dot(x.b[2], x.centre)};
    f.other[0] = {x.b[0].x, x.b[1].x, x.b[2].x};
    f.other[1] = {x.b[0].y, x.b[1].y, x.b[2].y};
    f.other[2] = {x.b[0].z, x.b[1].z, x.b[2].z};
  }
  f.sign = component(f.other_centre, f.axis) < 0 ? -1.0f : 1.0f;
  return f;
}

MENISCUS_HD inline void touch_faces(const Axes& x, int axis, const Pose& reference, float reach,
                                    Manifold& out) {
  const Faces f = faces_of(x, axis);
  const int u = (f.axis + 1) % 3, v = (f.axis + 2) % 3;
  Polygon face = incident_face(f);
  face = clipped(face, u, 1, component(f.half, u), 1);
  face = clipped(face, u, -1, component(f.half, u), 2);
  face = clipped(face, v, 1, component(f.half, v), 3);
  face = clipped(face, v, -1, component(f.half, v), 4);
  const float surface = component(f.half, f.axis);
  Polygon near;
  for (uint32_t k = 0; k < face.count; ++k) {
    const float distance = f.sign * component(face.corners[k].at, f.axis) - surface;
    if (distance <= reach) near.add(face.corners[k].at, face.corners[k].feature);
  }
  near = reduced(near, f);
  const Vec3 outward = rotate(reference.rotation, f.sign * unit_axis(f.axis));
  out.normal = axis < 3 ? -outward : outward;
  const uint32_t code = static_cast<uint32_t>(axis) << 8 | (f.sign > 0 ? 1u << 7 : 0u);
  for (uint32_t k = 0; k < near.count; ++k) {
    const float distance = f.sign * component(near.corners[k].at, f.axis) - surface;
    const Vec3 on_other = to_world(reference, near.corners[k].at);
    out.add(on_other - 0.5f * distance * outward, distance, code | near.corners[k].feature);
  }
}

/// The edge of a box along `axis` that is furthest in a direction: its middle.
MENISCUS_HD inline Vec3 edge_middle(Vec3 half, Vec3 direction, int axis) {
  Vec3 middle{direction.x > 0 ? half.x : -half.x, direction.y > 0 ? half.y : -half.y,
              direction.z > 0 ? half.z : -half.z};
  set_component(middle, axis, 0);
  return middle;
}

MENISCUS_HD inline void touch_edges(const Axes& x, const Best& best, const Pose& a, Manifold& out) {
  const int of_a = (best.axis - 6) / 3, of_b = (best.axis - 6) % 3;
  Vec3 n = edge_axis(x, of_a, of_b);
  if (dot(n, x.centre) < 0) n = -n;  // from a to b
  const Vec3 p = edge_middle(x.half_a, n, of_a);
  const Vec3 into_a{-dot(n, x.b[0]), -dot(n, x.b[1]), -dot(n, x.b[2])};
  const Vec3 local = edge_middle(x.half_b, into_a, of_b);
  const Vec3 q = x.centre + local.x * x.b[0] + local.y * x.b[1] + local.z * x.b[2];
  // The nearest point of the first line to the second.
  const Vec3 d = unit_axis(of_a), e = x.b[of_b], r = q - p;
  const float b = dot(d, e), along = (dot(r, d) - b * dot(r, e)) / (1 - b * b);
  out.normal = rotate(a.rotation, -n);
  const Vec3 on_a = to_world(a, p + along * d);
  out.add(on_a - 0.5f * best.distance * out.normal, best.distance, static_cast<uint32_t>(best.axis) << 8);
}

}  // namespace meniscus::collision::box_box

namespace meniscus::collision {

/// Finds up to four points at which the boxes are within `reach`.
MENISCUS_HD inline void touch_boxes(const Pose& a, Vec3 half_a, const Pose& b, Vec3 half_b, float reach,
                                    Manifold& out) {
  using namespace box_box;
  const Axes x = axes_of(a, half_a, b, half_b);
  const Vec3 least = min(half_a, half_b);
  const float tolerance =
      rigid_contact_tuning::face_preference * pbd::min(least.x, pbd::min(least.y, least.z));
  const Best face = best_face(x, tolerance);
  if (face.distance > reach) return;
  const Best edges = best_edges(x);
  if (edges.distance > reach) return;
  if (edges.distance > face.distance + tolerance) return touch_edges(x, edges, a, out);
  touch_faces(x, face.axis, face.axis < 3 ? a : b, reach, out);
}

}  // namespace meniscus::collision
