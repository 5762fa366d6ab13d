// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The point of a triangle that is deepest in a shape, or nearest to it. After Macklin, Erleben, Müller,
// Chentanez, Jeschke & Kim 2020, "Local optimization for robust signed distance field collision". Departure:
// projected gradient steps take the place of Frank–Wolfe. Outside the shape they are alternating projections,
// which end at a box's corner or edge, where Frank–Wolfe zigzags.
#pragma once

#include "collision/body/tuning.h"
#include "collision/contact/shape.h"
#include "collision/mesh/triangle.h"

namespace meniscus::collision {

/// A point of a triangle, and the nearest surface of a shape.
struct FaceSample {
  Vec3 weights;           ///< barycentric
  SurfaceSample surface;  ///< in the frame of the triangle
};

/// The straight motion of a triangle over a substep, in a shape's frame.
struct FaceMotion {
  Triangle from, to;
};

MENISCUS_HD inline Vec3 point_of(const Triangle& t, Vec3 weights) {
  return weights.x * t.a + weights.y * t.b + weights.z * t.c;
}

MENISCUS_HD inline Triangle between(const FaceMotion& m, float fraction) {
  return {m.from.a + fraction * (m.to.a - m.from.a), m.from.b + fraction * (m.to.b - m.from.b),
          m.from.c + fraction * (m.to.c - m.from.c)};
}

/// The largest displacement of any of its points, m.
MENISCUS_HD inline float displacement_of(const FaceMotion& m) {
  return sqrtf(pbd::max(squared_length(m.to.a - m.from.a),
                        pbd::max(squared_length(m.to.b - m.from.b), squared_length(m.to.c - m.from.c))));
}

/// The largest distance of a corner from the centre, m.
MENISCUS_HD inline float radius_of(const Triangle& t) {
  const Vec3 centre = (1.0f / 3) * (t.a + t.b + t.c);
  return sqrtf(pbd::max(squared_length(t.a - centre),
                        pbd::max(squared_length(t.b - centre), squared_length(t.c - centre))));
}

/// Barycentric weights of the triangle's point that is nearest to p.
MENISCUS_HD inline Vec3 nearest_weights(const Triangle& t, Vec3 p) {
  const Vec3 q = p + offset_to_triangle(t, p), n = area_normal(t);
  const Vec3 areas{pbd::max(dot(cross(t.b - q, t.c - q), n), 0.0f),
                   pbd::max(dot(cross(t.c - q, t.a - q), n), 0.0f),
                   pbd::max(dot(cross(t.a - q, t.b - q), n), 0.0f)};
  const float sum = areas.x + areas.y + areas.z;
  return sum > 0 ? areas / sum : Vec3{1, 0, 0};
}

/// The distance field of one shape that is not a plane, sampled at points of a triangle.
struct FaceField {
  const ShapeSet& set;
  const Shape& shape;
  float reach;  ///< m, up to which distances must be exact

  MENISCUS_HD FaceSample at(const Triangle& t, Vec3 weights) const {
    return {weights, detail::local_surface(set, shape, point_of(t, weights), reach)};
  }

  /// A quick test of whether any part of the moving face may come within reach. It may not where the centre
  /// is too far away at the end.
  MENISCUS_HD bool may_reach(const FaceMotion& m) const {
    constexpr float third = 1.0f / 3;
    return at(m.to, {third, third, third}).surface.distance < reach;
  }

  /// The best of the corners, the centre and the midpoints of the sides.
  MENISCUS_HD FaceSample seed(const Triangle& t) const {
    FaceSample best = at(t, {1.0f / 3, 1.0f / 3, 1.0f / 3});
    for (int k = 0; k < 6; ++k) {
      const float on = k < 3 ? 1.0f : 0.0f, off = k < 3 ? 0.0f : 0.5f;
      const int corner = k % 3;
      const FaceSample other =
          at(t, {corner == 0 ? on : off, corner == 1 ? on : off, corner == 2 ? on : off});
      if (other.surface.distance < best.surface.distance) best = other;
    }
    return best;
  }

  /// Descends from a sample, to `tolerance` (m). From outside, the step to the surface and back onto the
  /// triangle never increases the distance. Beyond that, steps are shortened where they do. Along an edge,
  /// steps are short and many. So the sum of the last two steps is repeated and doubled while it descends
  /// (Hooke & Jeeves 1961).
  MENISCUS_HD FaceSample descend(const Triangle& t, FaceSample best, float tolerance) const {
    float beyond = face_tuning::first_step * radius_of(t);
    Vec3 last = best.weights, before_last = last;
    for (int k = 0; k < face_tuning::descent_steps; ++k) {
      const float step = pbd::max(best.surface.distance, 0.0f) + beyond;
      const FaceSample next =
          at(t, nearest_weights(t, point_of(t, best.weights) - step * best.surface.normal));
      if (next.surface.distance < best.surface.distance - face_tuning::least_gain * tolerance) {
        best = next;
        best = go_on(t, best, best.weights - before_last);
        before_last = last;
        last = best.weights;
        beyond = face_tuning::longer * beyond;
      } else {
        if (beyond == 0) break;
        beyond = beyond > tolerance ? face_tuning::shorter * beyond : 0;
      }
    }
    return best;
  }

  MENISCUS_HD FaceSample go_on(const Triangle& t, FaceSample best, Vec3 displacement) const {
    for (float far = 1; far < face_tuning::most_repeated; far *= 2) {
      const Vec3 weights = inside(best.weights + far * displacement);
      const FaceSample next = at(t, weights);
      if (!(next.surface.distance < best.surface.distance)) break;
      best = next;
    }
    return best;
  }

  /// Maps weights that sum to 1 to weights that are not negative.
  MENISCUS_HD static Vec3 inside(Vec3 weights) {
    const Vec3 w = max(weights, {0, 0, 0});
    return w / (w.x + w.y + w.z);
  }

  /// The triangle's point of least signed distance.
  MENISCUS_HD FaceSample nearest(const Triangle& t, float tolerance) const {
    if (shape.kind == ShapeKind::sphere) return at(t, nearest_weights(t, {0, 0, 0}));
    return descend(t, seed(t), tolerance);
  }
};

/// The samples at the corners of a face.
struct FaceCorners {
  SurfaceSample a, b, c;
};

MENISCUS_HD inline FaceCorners corners_of(const FaceField& field, const Triangle& t) {
  return {field.at(t, {1, 0, 0}).surface, field.at(t, {0, 1, 0}).surface, field.at(t, {0, 0, 1}).surface};
}

MENISCUS_HD inline float least(const FaceCorners& s) {
  return pbd::min(s.a.distance, pbd::min(s.b.distance, s.c.distance));
}

/// Whether some point of a face may be nearer by `dip` (m) than all of its corners. The distance from a
/// convex shape is a convex function, so it lies above its tangents at the corners. The tangents are mixed by
/// a point's weights b. What remains is the mean of the corners' distances, less Σ bᵢ bⱼ (nᵢ − nⱼ)·(xᵢ − xⱼ)
/// over the sides. This sum is at most a third of its largest factor. Shapes that may not be convex are
/// sampled at more points as well.
MENISCUS_HD inline bool may_dip(const FaceField& field, const Triangle& t, float dip) {
  const FaceCorners s = corners_of(field, t);
  const float largest =
      pbd::max(dot(s.a.normal - s.b.normal, t.a - t.b),
               pbd::max(dot(s.b.normal - s.c.normal, t.b - t.c), dot(s.c.normal - s.a.normal, t.c - t.a)));
  if (largest > 3 * dip) return true;
  return !is_convex(field.shape.kind) &&
         field.seed(t).surface.distance < least(s) - face_tuning::sampled_dip * dip;
}

/// Where a face meets a shape during its motion.
struct FaceMeeting {
  FaceSample sample;
  Triangle face;  ///< the face at that time, in the shape's frame
};

/// Where the moving face first comes within `touch` (m) of the shape and moves on into it, by conservative
/// advancement. Where it does not, its nearest point at the end. A face that moves by less than `touch` is
/// tested at the end alone. A face that slides along a surface for more than half as many `touch` as there
/// are steps is tested where the steps end and at its own end: the nearer of the two counts.
MENISCUS_HD inline FaceMeeting meet_face(const FaceField& field, const FaceMotion& m, float touch) {
  const float displacement = displacement_of(m), tolerance = face_tuning::advance_tolerance * touch;
  const float least = face_tuning::advance * touch;
  float t = displacement > touch ? 0.0f : 1.0f;
  FaceMeeting last{{{1, 0, 0}, {1e30f, {0, 1, 0}}}, m.from};
  for (int k = 0; k < face_tuning::advance_steps && t < 1; ++k) {
    last.face = between(m, t);
    last.sample = field.nearest(last.face, tolerance);
    const SurfaceSample& s = last.sample.surface;
    const Vec3 path = point_of(m.to, last.sample.weights) - point_of(m.from, last.sample.weights);
    if (s.distance < touch && dot(s.normal, path) < 0) return last;
    t += pbd::max(s.distance - least, least) / displacement;
  }
  const FaceMeeting end{field.nearest(m.to, tolerance), m.to};
  return t < 1 && last.sample.surface.distance < end.sample.surface.distance ? last : end;
}

}  // namespace meniscus::collision
