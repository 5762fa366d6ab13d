// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Casts rays against convex shapes.
#include "collision/rigid/rays.h"

#include <algorithm>
#include <cmath>

namespace meniscus::collision {

namespace {

/// The segment of a ray inside a convex set, clipped by one bound of the set after another.
struct Stretch {
  const btVector3 &from, displacement;
  float first = 0, last = 1;
  btVector3 normal{0, 0, 0};  ///< at its beginning

  void enter(float fraction, const btVector3& through) {
    if (fraction > first) first = fraction, normal = through;
  }
  void leave(float fraction) { last = std::min(last, fraction); }
  void make_empty() { last = -1; }
  bool is_empty() const { return first > last; }

  void cut_by_plane(const btVector3& plane, float offset) {
    const float height = plane.dot(from) - offset, speed = plane.dot(displacement);
    if (speed < 0) {
      enter(-height / speed, plane);
    } else if (speed > 0) {
      leave(-height / speed);
    } else if (height > 0) {
      make_empty();
    }
  }

  /// Clips by a ball around `centre`, or, without the component along `axis`, by a cylinder.
  void cut_by_round(const btVector3& centre, const btVector3& axis, float radius) {
    const btVector3 start = from - centre, p = start - start.dot(axis) * axis;
    const btVector3 d = displacement - displacement.dot(axis) * axis;
    const float a = d.length2(), b = p.dot(d);
    if (a == 0) {
      if (p.length2() > radius * radius) make_empty();
      return;
    }
    // From the nearest point on the line: the usual c = p² − r² loses accuracy for a distant start.
    const btVector3 nearest = p - b / a * d;
    const float half_square = (radius * radius - nearest.length2()) / a;
    if (half_square < 0) return make_empty();
    const float half = std::sqrt(half_square), middle = -b / a;
    enter(middle - half, (nearest - half * d) / radius);
    leave(middle + half);
  }
};

const btVector3 no_axis{0, 0, 0}, y_axis{0, 1, 0};

bool keep_nearer(const Stretch& stretch, ConvexRayHit& hit) {
  if (stretch.is_empty() || stretch.first >= hit.fraction) return false;
  hit = {stretch.first, stretch.normal};
  return true;
}

bool cast_at_capsule(const btCapsuleShape& capsule, const Stretch& whole, ConvexRayHit& hit) {
  bool met = false;
  for (const float end : {-capsule.getHalfHeight(), capsule.getHalfHeight()}) {
    Stretch in_ball = whole;
    in_ball.cut_by_round({0, end, 0}, no_axis, capsule.getRadius());
    met |= keep_nearer(in_ball, hit);
  }
  Stretch between = whole;
  between.cut_by_round({0, 0, 0}, y_axis, capsule.getRadius());
  between.cut_by_plane(y_axis, capsule.getHalfHeight());
  between.cut_by_plane(-y_axis, capsule.getHalfHeight());
  return keep_nearer(between, hit) || met;
}

}  // namespace

bool cast_ray_at(const btConvexShape& shape, const btVector3& from, const btVector3& to, ConvexRayHit& hit) {
  Stretch stretch{from, to - from};
  switch (shape.getShapeType()) {
    case CAPSULE_SHAPE_PROXYTYPE:
      return cast_at_capsule(static_cast<const btCapsuleShape&>(shape), stretch, hit);
    case SPHERE_SHAPE_PROXYTYPE:
      stretch.cut_by_round({0, 0, 0}, no_axis, static_cast<const btSphereShape&>(shape).getRadius());
      break;
    case CYLINDER_SHAPE_PROXYTYPE: {
      const btVector3 half = static_cast<const btCylinderShape&>(shape).getHalfExtentsWithMargin();
      stretch.cut_by_round({0, 0, 0}, y_axis, half.x());
      stretch.cut_by_plane(y_axis, half.y());
      stretch.cut_by_plane(-y_axis, half.y());
      break;
    }
    case BOX_SHAPE_PROXYTYPE: {
      const btVector3 half = static_cast<const btBoxShape&>(shape).getHalfExtentsWithMargin();
      for (int axis = 0; axis < 3; ++axis) {
        btVector3 normal(0, 0, 0);
        normal[axis] = 1;
        stretch.cut_by_plane(normal, half[axis]);
        stretch.cut_by_plane(-normal, half[axis]);
      }
      break;
    }
    default:
      for (const auto& plane : static_cast<const HullPlanes*>(shape.getUserPointer())->planes) {
        stretch.cut_by_plane(plane.normal, plane.offset);
      }
  }
  return keep_nearer(stretch, hit);
}

}  // namespace meniscus::collision
