// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The contacts of round parts: balls, and capsules as balls along a segment.
#pragma once

#include "collision/rigid_contact/manifold.h"
#include "collision/rigid_contact/tuning.h"

namespace meniscus::collision {

struct Segment {
  Vec3 from, to;

  MENISCUS_HD Vec3 at(float t) const { return from + t * (to - from); }
};

/// The axis of a round part. A ball has an axis without length.
MENISCUS_HD inline Segment axis_of(const Pose& pose, const Convex& part) {
  const Vec3 half =
      part.kind == ConvexKind::capsule ? rotate(pose.rotation, {0, part.size.y, 0}) : Vec3{0, 0, 0};
  return {pose.position - half, pose.position + half};
}

/// Where on the segment the point nearest to p is, 0 to 1.
MENISCUS_HD inline float nearest_on(const Segment& s, Vec3 p) {
  const Vec3 d = s.to - s.from;
  const float size2 = dot(d, d);
  return size2 > 0 ? pbd::clamp(dot(p - s.from, d) / size2, 0, 1) : 0;
}

/// A ball against a ball.
MENISCUS_HD inline void touch_balls(Vec3 a, float radius_a, Vec3 b, float radius_b, float reach,
                                    uint32_t feature, Manifold& out) {
  const Vec3 d = a - b;
  const float distance = length(d) - radius_a - radius_b;
  if (distance > reach) return;
  out.normal = normalized_or(d, {0, 1, 0});
  out.add(b + (radius_b + 0.5f * distance) * out.normal, distance, feature);
}

/// Two capsules: at the nearest points, or at both ends of the stretch along which parallel axes face each
/// other.
MENISCUS_HD inline void touch_capsules(const Segment& a, float radius_a, const Segment& b, float radius_b,
                                       float reach, Manifold& out) {
  const Vec3 d = a.to - a.from, e = b.to - b.from, r = a.from - b.from;
  const float dd = dot(d, d), ee = dot(e, e), de = dot(d, e), denominator = dd * ee - de * de;
  const auto touch_at = [&](float s, uint32_t feature, Manifold& to) {
    touch_balls(a.at(s), radius_a, b.at(nearest_on(b, a.at(s))), radius_b, reach, feature, to);
  };
  if (denominator > rigid_contact_tuning::parallel * dd * ee) {
    const float s = pbd::clamp((de * dot(e, r) - ee * dot(d, r)) / denominator, 0, 1);
    return touch_at(nearest_on(a, b.at(nearest_on(b, a.at(s)))), 0, out);
  }
  Manifold first, second;
  const float s = nearest_on(a, b.from), t = nearest_on(a, b.to);
  touch_at(s, 1, first);
  if (s != t) touch_at(t, 2, second);
  out = first.count ? first : second;
  if (first.count && second.count) out.add(second.points[0].position, second.points[0].distance, 2);
}

/// A ball, `a`, against a box.
MENISCUS_HD inline void touch_box_ball(Vec3 ball, float radius, const Pose& box, Vec3 half, float reach,
                                       uint32_t feature, Manifold& out) {
  const Vec3 p = to_local(box, ball), nearest = max(-half, min(half, p));
  Vec3 n = p - nearest;
  float distance = length(n) - radius;
  if (distance > reach) return;
  if (n == Vec3{0, 0, 0}) {  // the centre is inside: out by the nearest face
    const Vec3 depth = half - abs(p);
    const int axis = depth.x < depth.y ? (depth.x < depth.z ? 0 : 2) : (depth.y < depth.z ? 1 : 2);
    n = (component(p, axis) < 0 ? -1.0f : 1.0f) * unit_axis(axis);
    distance = -component(depth, axis) - radius;
  } else {
    n = n / length(n);
  }
  out.normal = rotate(box.rotation, n);
  out.add(ball - (radius + 0.5f * distance) * out.normal, distance, feature);
}

/// Where a segment is nearest to a box, 0 to 1. The distance is convex along the segment.
MENISCUS_HD inline float nearest_to_box(const Segment& s, const Pose& box, Vec3 half) {
  const Segment local{to_local(box, s.from), to_local(box, s.to)};
  const auto distance = [&](float t) {
    const Vec3 p = local.at(t), d = p - max(-half, min(half, p));
    return dot(d, d);
  };
  float low = 0, high = 1;
  for (int k = 0; k < 24; ++k) {  // a third of the interval goes in each round, to a float's rounding
    const float t = low + (high - low) / 3, u = high - (high - low) / 3;
    if (distance(t) <= distance(u))
      high = u;
    else
      low = t;
  }
  return 0.5f * (low + high);
}

/// A capsule, `a`, against a box: at its ends and at its nearest point, those that agree with the deepest.
MENISCUS_HD inline void touch_box_capsule(const Segment& a, float radius, const Pose& box, Vec3 half,
                                          float reach, Manifold& out) {
  Manifold each[3];
  touch_box_ball(a.from, radius, box, half, reach, 1, each[0]);
  touch_box_ball(a.to, radius, box, half, reach, 2, each[1]);
  touch_box_ball(a.at(nearest_to_box(a, box, half)), radius, box, half, reach, 3, each[2]);
  int deepest = -1;
  for (int k = 0; k < 3; ++k) {
    if (each[k].count && (deepest < 0 || each[k].points[0].distance < each[deepest].points[0].distance))
      deepest = k;
  }
  if (deepest < 0) return;
  out.normal = each[deepest].normal;
  for (const Manifold& m : each) {
    if (m.count && dot(m.normal, out.normal) > rigid_contact_tuning::same_normal)
      out.add(m.points[0].position, m.points[0].distance, m.points[0].feature);
  }
}

}  // namespace meniscus::collision
