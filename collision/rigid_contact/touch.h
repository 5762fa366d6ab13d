// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The contact of any two convex parts.
#pragma once

#include "collision/rigid_contact/box_box.h"
#include "collision/rigid_contact/round.h"

namespace meniscus::collision {

/// A part, `a`, against a half-space: its lowest points.
MENISCUS_HD inline void touch_plane(const Pose& a, const Convex& part, const Pose& plane, float reach,
                                    Manifold& out) {
  out.normal = rotate(plane.rotation, {0, 1, 0});
  const auto note = [&](Vec3 p, float radius, uint32_t feature, Manifold& to) {
    const float distance = dot(p - plane.position, out.normal) - radius;
    if (distance <= reach) to.add(p - (radius + 0.5f * distance) * out.normal, distance, feature);
  };
  if (part.kind != ConvexKind::box) {
    const Segment axis = axis_of(a, part);
    note(axis.from, part.size.x, 1, out);
    if (part.kind == ConvexKind::capsule) note(axis.to, part.size.x, 2, out);
    return;
  }
  // The face that looks most against the plane has its four lowest corners.
  const Vec3 n = rotate(conjugate(a.rotation), out.normal), size = abs(n);
  const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  for (uint32_t k = 0; k < 4; ++k) {
    Vec3 corner{0, 0, 0};
    set_component(corner, axis,
                  component(n, axis) > 0 ? -component(part.size, axis) : component(part.size, axis));
    set_component(corner, u, k & 1 ? component(part.size, u) : -component(part.size, u));
    set_component(corner, v, k & 2 ? component(part.size, v) : -component(part.size, v));
    const uint32_t face = 2 * static_cast<uint32_t>(axis) + (component(n, axis) > 0);
    note(to_world(a, corner), 0, face << 4 | k, out);
  }
}

/// Finds up to four points at which the parts are within `reach`. A plane may only be `b`.
MENISCUS_HD inline Manifold touch(const Pose& a, const Convex& of_a, const Pose& b, const Convex& of_b,
                                  float reach) {
  Manifold out;
  const bool box_a = of_a.kind == ConvexKind::box, box_b = of_b.kind == ConvexKind::box;
  if (of_b.kind == ConvexKind::plane) {
    touch_plane(a, of_a, b, reach, out);
  } else if (box_a && box_b) {
    touch_boxes(a, of_a.size, b, of_b.size, reach, out);
  } else if (box_a) {
    const Segment axis = axis_of(b, of_b);
    if (of_b.kind == ConvexKind::capsule)
      touch_box_capsule(axis, of_b.size.x, a, of_a.size, reach, out);
    else
      touch_box_ball(axis.from, of_b.size.x, a, of_a.size, reach, 0, out);
    out.normal = -out.normal;
  } else if (box_b) {
    const Segment axis = axis_of(a, of_a);
    if (of_a.kind == ConvexKind::capsule)
      touch_box_capsule(axis, of_a.size.x, b, of_b.size, reach, out);
    else
      touch_box_ball(axis.from, of_a.size.x, b, of_b.size, reach, 0, out);
  } else {
    touch_capsules(axis_of(a, of_a), of_a.size.x, axis_of(b, of_b), of_b.size.x, reach, out);
  }
  return out;
}

}  // namespace meniscus::collision
