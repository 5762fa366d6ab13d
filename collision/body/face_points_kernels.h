// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of face_points.inl. A triangle has at most one point, and a point is a particle after all
// others. Points are numbered in the order of their triangles.
#pragma once

#include "collision/body/face_points_nearest.h"
#include "collision/body/tuning.h"
#include "collision/contact/shape_contacts.h"
#include "collision/contact/tuning.h"
#include "pbd/device/base/atomics.h"
#include "pbd/surface_tree/surface.h"

namespace meniscus::collision::face_kernels {

using pbd::ParticleView;
using pbd::SurfaceTriangle;
using pbd::Vec4;
using pbd::View;

MENISCUS_HD inline float component(Vec3 v, uint32_t k) {
  return k == 0 ? v.x : k == 1 ? v.y : v.z;
}

/// The motion of a triangle over the substep.
MENISCUS_HD inline FaceMotion motion_of(const ParticleView& p, const SurfaceTriangle& t) {
  const uint32_t a = p.sorted + t.a, b = p.sorted + t.b, c = p.sorted + t.c;
  const View<const Vec4> position = p.position;
  return {{pbd::load(p.previous, a).xyz(), pbd::load(p.previous, b).xyz(), pbd::load(p.previous, c).xyz()},
          {pbd::load(position, a).xyz(), pbd::load(position, b).xyz(), pbd::load(position, c).xyz()}};
}

MENISCUS_HD inline Triangle in_frame(const Triangle& t, const Pose& pose) {
  return {to_local(pose, t.a), to_local(pose, t.b), to_local(pose, t.c)};
}

/// The same motion relative to a shape whose final pose is `pose`.
MENISCUS_HD inline FaceMotion motion_beside(const Shape& shape, const Pose& pose, const FaceMotion& m) {
  const Pose& start = shape.body == pbd::no_index ? shape.pose : shape.start;
  return {in_frame(m.from, start), in_frame(m.to, pose)};
}

MENISCUS_HD inline Aabb bounds_of(const FaceMotion& m) {
  const Triangle &from = m.from, &to = m.to;
  return {min(min(min(from.a, from.b), from.c), min(min(to.a, to.b), to.c)),
          max(max(max(from.a, from.b), from.c), max(max(to.a, to.b), to.c))};
}

// Points stop at less than 1 − slack. So where vertices rest, even slightly pressed in, points touch before
// they push. If points appeared only where they push, resting cloth with faces near the slack would be kicked
// for ever.
static_assert(shape_tuning::face_radius < 1 - face_tuning::slack);

/// Decides whether a face needs a point. It does where it comes near a solid, and clearly nearer than its
/// vertices.
struct Decide {
  ShapeSet set;
  shape_contact_kernels::Touches touches;
  View<const SurfaceTriangle> triangles;
  ParticleView particles;
  View<uint32_t> needed;  ///< by triangle, 1 or 0; empty while points are disabled
  View<Vec4> weights;     ///< by triangle, where needed
  View<uint32_t> wanted;  ///< one element

  MENISCUS_HD void operator()(uint32_t n) const {
    const SurfaceTriangle t = triangles[n];
    const FaceSample best = deepest_point(t, n / (triangles.count / set.worlds));
    const bool needs = best.surface.distance < nothing().surface.distance;
    if (needed.count == 0) {
      if (needs) pbd::atomic_max(wanted[0], 1);
      return;
    }
    needed[n] = needs;
    if (needs) weights[n] = pbd::with_w(best.weights, 0);
  }

  MENISCUS_HD static FaceSample nothing() { return {{1, 0, 0}, {1e30f, {0, 1, 0}}}; }

  /// The deepest point over all shapes, if the face needs one. A held face needs none at fixed shapes.
  MENISCUS_HD FaceSample deepest_point(const SurfaceTriangle& t, uint32_t world) const {
    const FaceMotion motion = motion_of(particles, t);
    const Touch touch = touches.of(particles.sorted + t.a);
    const uint32_t first = is_held(t) ? set.fixed : 0;
    const Aabb box = bounds_of(motion);
    const float reach = face_tuning::reach * touch.radius;
    FaceSample best = nothing();
    if (!is_finite(box.lower) || !is_finite(box.upper)) return best;
    for (uint32_t k = first; k < set.of_world(); ++k) {
      const Shape& shape = set.shapes[set.number(k, world)];
      if (shape.kind == ShapeKind::plane || out_of_reach(shape, box.lower, box.upper, reach)) continue;
      if (!collide(shape, touch.filter) || touches.is_face_attached(t, shape.body)) continue;
      const FaceSample found =
          deepest_point_in(shape, motion_beside(shape, shape.pose, motion), touch.radius, reach);
      if (found.surface.distance < best.surface.distance) best = found;
    }
    return best;
  }

  MENISCUS_HD bool is_held(const SurfaceTriangle& t) const {
    const View<const Vec4> vertex = particles.position.from(particles.sorted);
    return vertex[t.a].w + vertex[t.b].w + vertex[t.c].w == 0;
  }

  MENISCUS_HD FaceSample deepest_point_in(const Shape& shape, const FaceMotion& motion, float radius,
                                          float reach) const {
    const FaceField field{set, shape, radius_of(motion.to) + displacement_of(motion) + reach};
    if (!field.may_reach(motion)) return nothing();
    const float touch = face_tuning::touch * radius, dip = face_tuning::slack * radius;
    if (displacement_of(motion) <= touch && !may_dip(field, motion.to, dip)) return nothing();
    const FaceMeeting meeting = meet_face(field, motion, touch);
    const float distance = meeting.sample.surface.distance;
    const float corners = least(corners_of(field, meeting.face));
    return distance < reach && distance < corners - dip ? meeting.sample : nothing();
  }
};

/// The points in use, as kernels read them.
struct Points {
  View<const SurfaceTriangle> triangles;
  View<const uint32_t> needed;       ///< by triangle
  View<const uint32_t> number;       ///< by triangle: number of its point, where needed; last: the total
  View<const Vec4> weights;          ///< by triangle
  View<const uint32_t> triangle_of;  ///< by point
  View<const uint32_t> corner_start, corners;  ///< CSR, by vertex: its corners, 3 · triangle + corner
  uint32_t first = 0;                          ///< the particle that is point 0
  uint32_t room = 0;
  uint32_t faces = 1, vertices = 0;  ///< of a world

  MENISCUS_HD uint32_t count() const {
    const uint32_t total = number[number.count - 1];
    return total < room ? total : room;
  }
  MENISCUS_HD bool has_point(uint32_t triangle) const { return needed[triangle] && number[triangle] < room; }
  /// The mean of the corners' values, with the point's weights.
  MENISCUS_HD Vec3 mix(View<const Vec4> values, uint32_t sorted, uint32_t triangle) const {
    const SurfaceTriangle t = triangles[triangle];
    const Vec4 w = weights[triangle];
    return w.x * values[sorted + t.a].xyz() + w.y * values[sorted + t.b].xyz() +
           w.z * values[sorted + t.c].xyz();
  }
  /// Calls visit(particle, weight) for the points on the triangles of a vertex, in a fixed order.
  template <class Visit>
  MENISCUS_HD void for_each_at(uint32_t vertex, const Visit& visit) const {
    for (uint32_t k = corner_start[vertex]; k < corner_start[vertex + 1]; ++k) {
      const uint32_t triangle = corners[k] / 3;
      if (has_point(triangle))
        visit(first + number[triangle], component(weights[triangle].xyz(), corners[k] % 3));
    }
  }
};

struct ListPoints {
  View<const uint32_t> needed, number;
  View<uint32_t> triangle_of, wanted;

  MENISCUS_HD void operator()(uint32_t triangle) const {
    if (triangle == 0) pbd::atomic_max(wanted[0], number[number.count - 1]);
    if (needed[triangle] && number[triangle] < triangle_of.count) triangle_of[number[triangle]] = triangle;
  }
};

/// Makes a particle of each point. Particles of unused points are placed at a vertex and find no contacts.
struct MakeParticles {
  Points points;
  View<uint32_t> triangle_of;
  ParticleView particles;
  View<Vec4> previous;
  View<pbd::Phase> phase;
  View<uint32_t> slot, number;

  MENISCUS_HD void operator()(uint32_t n) const {
    const uint32_t i = points.first + n, sorted = particles.sorted;
    const bool used = n < points.count();
    const uint32_t triangle = used ? points.triangle_of[n] : 0;
    const uint32_t corner = sorted + points.triangles[triangle].a;
    particles.accumulated_delta[i] = {0, 0, 0, 0};
    phase[i] = pbd::phase_vertex | pbd::phase_face | pbd::phase_group(particles.phase[corner]) |
               (of_any(points.triangles[triangle]) & pbd::phase_overlapping);
    slot[i] = number[i] = pbd::vertex_slot + (used ? number_of(n) : i - sorted);
    if (!used) {
      triangle_of[n] = pbd::no_index;
      particles.position[i] = previous[i] = pbd::with_w(particles.position[corner].xyz(), 0);
      particles.velocity[i] = {0, 0, 0, 0};
      return;
    }
    const Vec3 at = points.mix(particles.position, sorted, triangle);
    const float w = inverse_mass(triangle);  // Weigh sets the final value when contacts are known
    particles.position[i] = pbd::with_w(at, w);
    previous[i] = pbd::with_w(points.mix(previous, sorted, triangle), w);
    particles.velocity[i] = pbd::with_w(points.mix(particles.velocity, sorted, triangle), 0);
  }
  /// Of point n, behind the vertices of its world.
  MENISCUS_HD uint32_t number_of(uint32_t n) const {
    const uint32_t first_face = points.triangle_of[n] / points.faces * points.faces;
    return points.vertices + n - points.number[first_face];
  }
  /// Σ b² w over the corners.
  MENISCUS_HD float inverse_mass(uint32_t triangle) const {
    const uint32_t sorted = particles.sorted;
    const SurfaceTriangle t = points.triangles[triangle];
    const Vec4 b = points.weights[triangle];
    const View<Vec4> x = particles.position;
    return b.x * b.x * x[sorted + t.a].w + b.y * b.y * x[sorted + t.b].w + b.z * b.z * x[sorted + t.c].w;
  }
  MENISCUS_HD pbd::Phase of_any(const SurfaceTriangle& t) const {
    const uint32_t sorted = particles.sorted;
    return particles.phase[sorted + t.a] | particles.phase[sorted + t.b] | particles.phase[sorted + t.c];
  }
};

/// Counts the points with contacts at each vertex. While one of them is in a solid that its face overlapped
/// at insertion, the vertex keeps the flag for overlap as well.
struct CountAtVertices {
  Points points;
  View<const uint32_t> contact_start;
  View<uint32_t> at_vertex;
  View<pbd::Phase> phase;
  uint32_t sorted;

  MENISCUS_HD void operator()(uint32_t vertex) const {
    uint32_t count = 0;
    pbd::Phase any = 0;
    points.for_each_at(vertex, [&](uint32_t i, float) {
      count += contact_start[i] != contact_start[i + 1];
      any |= phase[i];
    });
    at_vertex[vertex] = count;
    if (any & pbd::phase_overlapping) phase[sorted + vertex] |= pbd::phase_overlapping;
  }
};

/// Whether contacts push a particle, or are about to.
MENISCUS_HD inline bool is_pushed(const pbd::ContactView& contacts, uint32_t i, Vec3 at) {
  for (uint32_t k = contacts.start[i]; k < contacts.start[i + 1]; ++k) {
    const pbd::Contact& c = contacts.contacts[k];
    if (pbd::is_attachment(c) || c.normal_multiplier != 0 || plane_distance(c, at) < c.radius) return true;
  }
  return false;
}

/// Whether contacts have pushed a particle at the end of the solve. Only such contacts bounce.
MENISCUS_HD inline bool was_pushed(const pbd::ContactView& contacts, uint32_t i) {
  for (uint32_t k = contacts.start[i]; k < contacts.start[i + 1]; ++k)
    if (contacts.contacts[k].normal_multiplier > 0) return true;
  return false;
}

/// Moves the points to their triangles.
struct Place {
  Points points;
  ParticleView particles;
  pbd::ContactView contacts;
  View<uint32_t> pushed;  ///< by point, 1 or 0

  MENISCUS_HD void operator()(uint32_t n) const {
    if (n >= points.count()) return;
    const uint32_t i = points.first + n;
    const Vec3 at = points.mix(particles.position, particles.sorted, points.triangle_of[n]);
    particles.position[i] = pbd::with_w(at, particles.position[i].w);
    particles.accumulated_delta[i] = {0, 0, 0, 0};
    pushed[n] = is_pushed(contacts, i, at);
  }
};

/// w = Σ b² n w over the corners. Each vertex is split among the n points that push it and its own contacts
/// (mass splitting, Tonge, Benevolenski & Voroshilov 2012). So all of them together do not move it too far.
/// Points that do not push are not counted, because otherwise the pushing points would converge slowly.
struct Weigh {
  Points points;
  ParticleView particles;
  pbd::ContactView contacts;
  View<const uint32_t> pushed;

  MENISCUS_HD void operator()(uint32_t n) const {
    if (n >= points.count()) return;
    const uint32_t triangle = points.triangle_of[n];
    const SurfaceTriangle t = points.triangles[triangle];
    const Vec4 b = points.weights[triangle];
    const float w = b.x * b.x * split_inverse_mass(t.a) + b.y * b.y * split_inverse_mass(t.b) +
                    b.z * b.z * split_inverse_mass(t.c);
    const uint32_t i = points.first + n;
    particles.position[i] = pbd::with_w(particles.position[i].xyz(), w);
  }
  MENISCUS_HD float split_inverse_mass(uint32_t vertex) const {
    const uint32_t i = particles.sorted + vertex;
    const Vec4 x = particles.position[i];
    if (is_held(contacts, i, x.w)) return 0;
    uint32_t count = is_pushed(contacts, i, x.xyz());
    points.for_each_at(vertex, [&](uint32_t point, float) { count += pushed[point - points.first]; });
    return static_cast<float>(count > 0 ? count : 1) * x.w;
  }
};

/// Transfers the positional impulse that a point has recorded to the vertices, which get fractions of it by
/// the point's weights.
struct TransferDisplacement {
  Points points;
  ParticleView particles;
  View<const uint32_t> at_vertex;

  MENISCUS_HD void operator()(uint32_t vertex) const {
    if (at_vertex[vertex] == 0) return;
    Vec3 positional_impulse{0, 0, 0};
    points.for_each_at(vertex, [&](uint32_t i, float weight) {
      positional_impulse +=
          weight * pbd::recorded_impulse(particles.position[i].w, particles.accumulated_delta[i].xyz());
    });
    const uint32_t i = particles.sorted + vertex;
    const Vec4 x = particles.position[i];
    const Vec3 delta = particles.accumulated_delta[i].xyz();
    particles.accumulated_delta[i] = pbd::with_w(delta + pbd::recorded_part(x.w) * positional_impulse, 0);
    particles.position[i] = pbd::with_w(x.xyz() + x.w * positional_impulse, x.w);
  }
};

/// Gives the points their triangles' velocities, saves these, and starts the accumulated delta anew.
struct PlaceVelocities {
  Points points;
  ParticleView particles;
  pbd::ContactView contacts;
  View<uint32_t> pushed;  ///< by point, 1 or 0
  View<Vec4> before;      ///< by point, m/s

  MENISCUS_HD void operator()(uint32_t n) const {
    if (n >= points.count()) return;
    const uint32_t i = points.first + n;
    const Vec3 v = points.mix(particles.velocity, particles.sorted, points.triangle_of[n]);
    particles.velocity[i] = before[n] = pbd::with_w(v, 0);
    particles.accumulated_delta[i] = {0, 0, 0, 0};
    pushed[n] = was_pushed(contacts, i);
  }
};

struct TransferVelocities {
  Points points;
  ParticleView particles;
  View<const uint32_t> at_vertex;
  View<const Vec4> before;  ///< by point, m/s
  pbd::Withstanding held;
  float dt;

  MENISCUS_HD void operator()(uint32_t vertex) const {
    if (at_vertex[vertex] == 0) return;
    Vec3 push{0, 0, 0};  // kg·m
    points.for_each_at(vertex, [&](uint32_t point, float weight) {
      const float w = particles.position[point].w;
      const Vec3 step = particles.velocity[point].xyz() - before[point - points.first].xyz();
      push += w > 0 ? (dt * weight / w) * step : weight * particles.accumulated_delta[point].xyz();
    });
    if (push == Vec3{0, 0, 0}) return;
    const uint32_t i = particles.sorted + vertex;
    const float w = particles.position[i].w;
    if (is_held(held.contacts, i, w)) return held.add(i, push);
    particles.velocity[i] = pbd::with_w(particles.velocity[i].xyz() + (w / dt) * push, 0);
  }
};

}  // namespace meniscus::collision::face_kernels
