// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The CCD fail-safe of face points. With few iterations and fast motion the solve may leave a face (nearly)
// inside a solid. The face's vertices are then moved out together. Mass splitting keeps a solve stable, but
// would need many more iterations for that.
#pragma once

#include "collision/body/body_kernels.h"
#include "collision/body/face_points_kernels.h"
#include "collision/body/tuning.h"

namespace meniscus::collision::face_kernels {

using body_kernels::ContactMotion;

/// The displacement that each face demands, m. The solids themselves are sampled again. A face may have slid
/// off the plane that stood for a solid, into another part of it.
struct Demand {
  Points points;
  ParticleView particles;
  pbd::ContactView contacts;
  ShapeSet set;
  shape_contact_kernels::Touches touches;
  View<const BodyProxy> bodies;
  View<const ContactMotion> body_motion;
  View<const uint32_t> stirred;  ///< by point: whether the last round moved its face; empty at first
  View<Vec4> demand;             ///< by point

  /// A face that overlapped the solid at insertion leaves it by its contacts alone.
  MENISCUS_HD void operator()(uint32_t n) const {
    const uint32_t i = points.first + n;
    Vec3 step{0, 0, 0};
    const bool unchanged = stirred.count && !stirred[n];  // it demanded nothing, and would again
    if (n < points.count() && !unchanged && contacts.start[i] != contacts.start[i + 1] &&
        !touches.may_overlap(i))
      step = step_of(points.triangle_of[n]);
    demand[n] = pbd::with_w(step, 0);
  }

  MENISCUS_HD Vec3 step_of(uint32_t triangle) const {
    const SurfaceTriangle t = points.triangles[triangle];
    const Touch touch = touches.of(particles.sorted + t.a);
    const FaceMotion motion = motion_of(particles, t);
    const Aabb box = bounds_of(motion);
    Vec3 step{0, 0, 0};
    if (!is_finite(box.lower) || !is_finite(box.upper)) return step;
    for (uint32_t k = 0; k < set.of_world(); ++k) {
      const Shape& shape = set.shapes[set.number(k, triangle / points.faces)];
      // The displacement of a body by contacts may be as large as its own motion, so the bounds are tested
      // with it.
      if (shape.kind == ShapeKind::plane || out_of_reach(shape, box.lower, box.upper, touch.radius)) continue;
      if (!collide(shape, touch.filter) || touches.is_face_attached(t, shape.body)) continue;
      const Vec3 other = step_from(shape, motion, t, touch.radius);
      if (squared_length(other) > squared_length(step)) step = other;
    }
    return step;
  }

  MENISCUS_HD Vec3 step_from(const Shape& shape, const FaceMotion& world, const SurfaceTriangle& t,
                             float radius) const {
    const Pose pose = pose_of(shape);
    const FaceMotion motion = collision::face_kernels::motion_beside(shape, pose, world);
    const FaceField field{set, shape, radius_of(motion.to) + displacement_of(motion) + radius};
    if (!field.may_reach(motion)) return {0, 0, 0};
    FaceMeeting meeting = meet_face(field, motion, face_tuning::least * radius);
    float lacking = lacking_of(motion, meeting, radius);
    if (lacking <= 0 &&
        displacement_of(motion) > face_tuning::least * radius) {  // there; the end may have another
      meeting = {field.nearest(motion.to, face_tuning::end_tolerance * radius), motion.to};
      lacking = lacking_of(motion, meeting, radius);
    }
    if (lacking <= 0) return {0, 0, 0};
    const FaceSample& s = meeting.sample;
    const Vec3 normal = rotate(pose.rotation, s.surface.normal);
    return lacking * displacement_factor(shape, t, s.weights, point_of(world.to, s.weights), normal) * normal;
  }

  /// The distance that the point of the meeting lacks at the end, from the plane that it met, m.
  MENISCUS_HD static float lacking_of(const FaceMotion& motion, const FaceMeeting& meeting, float radius) {
    const FaceSample& s = meeting.sample;
    const Vec3 displacement = point_of(motion.to, s.weights) - point_of(meeting.face, s.weights);
    const float distance = s.surface.distance + dot(displacement, s.surface.normal);
    const float wanted =
        displacement_of(motion) > radius ? face_tuning::enough_when_fast : face_tuning::enough;
    return distance < face_tuning::least * radius ? wanted * radius - distance : 0;
  }

  /// The pose of the shape after the displacement of its body by contacts.
  MENISCUS_HD Pose pose_of(const Shape& shape) const {
    if (shape.body == pbd::no_index) return shape.pose;
    const BodyProxy& body = bodies[shape.body];
    if (body.first == body.end) return shape.pose;
    const ContactMotion motion = body_motion[shape.body];
    return displaced(body.pose, motion.shift, motion.turn) * (inverse(body.pose) * shape.pose);
  }

  /// The factor from the lacking distance to the vertices' displacement. Some vertices may be held, so the
  /// others move further. The body moves the rest when it has got its impulse.
  MENISCUS_HD float displacement_factor(const Shape& shape, const SurfaceTriangle& t, Vec3 weights, Vec3 at,
                                        Vec3 normal) const {
    float mass = 0, free = 0;
    add_vertex(t.a, weights.x, mass, free);
    add_vertex(t.b, weights.y, mass, free);
    add_vertex(t.c, weights.z, mass, free);
    if (free < face_tuning::least_free) return 0;
    float body_w = 0;
    if (shape.body != pbd::no_index) {
      const BodyProxy& body = bodies[shape.body];
      body_w = inverse_mass_at(body, at - body.pose.position, normal);
    }
    return 1 / (free * (1 + mass * body_w));
  }
  MENISCUS_HD void add_vertex(uint32_t vertex, float weight, float& mass, float& free) const {
    const float w = particles.position[particles.sorted + vertex].w;
    if (w == 0) return;
    mass += 1 / w;
    free += weight;
  }
};

/// The displacement of a vertex by which it fulfils the demand of each of its faces; then the faces fulfil
/// theirs. Calls visit(point, part) with what each demand adds.
template <class Visit>
MENISCUS_HD Vec3 obey(const Points& points, View<const Vec4> demand, uint32_t vertex, const Visit& visit) {
  Vec3 step{0, 0, 0};
  points.for_each_at(vertex, [&](uint32_t point, float) {
    const Vec3 wanted = demand[point - points.first].xyz();
    const float size2 = dot(wanted, wanted);
    if (size2 == 0) return;
    const Vec3 part = pbd::max(1 - dot(step, wanted) / size2, 0.0f) * wanted;
    step += part;
    visit(point, part);
  });
  return step;
}

/// Gives the solid the opposite of the vertices' impulses. Marks the faces that will move.
struct Account {
  Points points;
  ParticleView particles;
  pbd::ContactView contacts;
  View<const Vec4> demand;
  View<uint32_t> stirred;

  MENISCUS_HD void operator()(uint32_t n) const {
    stirred[n] = 0;
    if (n >= points.count()) return;
    const SurfaceTriangle t = points.triangles[points.triangle_of[n]];
    stirred[n] = is_asked(t.a) || is_asked(t.b) || is_asked(t.c);
    const Vec3 wanted = demand[n].xyz();
    if (dot(wanted, wanted) == 0) return;
    const uint32_t i = points.first + n;
    const Vec3 impulse = given(t.a, i) + given(t.b, i) + given(t.c, i);
    uint32_t along = contacts.start[i];
    for (uint32_t k = along; k < contacts.start[i + 1]; ++k) {
      if (dot(contacts.contacts[k].normal, wanted) > dot(contacts.contacts[along].normal, wanted)) along = k;
    }
    contacts.contacts[along].tangent_multiplier += impulse;
  }
  MENISCUS_HD bool is_asked(uint32_t vertex) const {
    bool asked = false;
    points.for_each_at(vertex, [&](uint32_t point, float) {
      const Vec3 wanted = demand[point - points.first].xyz();
      asked = asked || dot(wanted, wanted) != 0;
    });
    return asked;
  }
  MENISCUS_HD Vec3 given(uint32_t vertex, uint32_t i) const {
    const float w = particles.position[particles.sorted + vertex].w;
    Vec3 self{0, 0, 0};
    if (w == 0) return self;
    obey(points, demand, vertex, [&](uint32_t point, Vec3 part) {
      if (point == i) self = part / w;
    });
    return self;
  }
};

struct Obey {
  Points points;
  ParticleView particles;
  View<const uint32_t> at_vertex;
  View<const Vec4> demand;

  MENISCUS_HD void operator()(uint32_t vertex) const {
    const uint32_t i = particles.sorted + vertex;
    const Vec4 x = particles.position[i];
    if (at_vertex[vertex] == 0 || x.w == 0) return;
    const Vec3 step = obey(points, demand, vertex, [](uint32_t, Vec3) {});
    particles.position[i] = pbd::with_w(x.xyz() + step, x.w);
    particles.accumulated_delta[i] = pbd::with_w(particles.accumulated_delta[i].xyz() + step, 0);
  }
};

}  // namespace meniscus::collision::face_kernels
