// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of BodyZones that find what meets: the substeps that fast bodies need, and the faces that a
// body would pass. A zone is named by one of its bodies.
#pragma once

#include "collision/body/body_kernels.h"
#include "collision/body/face_points_kernels.h"
#include "collision/body/tuning.h"
#include "pbd/device/base/atomics.h"
#include "pbd/math/union_find.h"

namespace meniscus::collision::zone_kernels {

using body_kernels::ContactSum;
using pbd::no_index;
using pbd::ParticleView;
using pbd::SurfaceTriangle;
using pbd::Vec4;
using pbd::View;

/// Finds the number of substeps in which no body moves too far relative to the faces that it meets.
struct Approach {
  ShapeSet set;
  shape_contact_kernels::Touches touches;
  View<const SurfaceTriangle> triangles;
  ParticleView particles;          ///< at the start of the step
  View<const RigidMotion> motion;  ///< by body, over the step
  View<const float> reach;         ///< by body, m
  View<const float> acceleration;  ///< by body, m/s²: cloth that presses will go on
  View<const float> size;          ///< by piece: of its faces, m
  View<uint32_t> needed;           ///< by world
  float dt;

  MENISCUS_HD void operator()(uint32_t n) const {
    const SurfaceTriangle t = triangles[n];
    const uint32_t world = n / (triangles.count / set.worlds);
    const CollisionFilter filter = touches.of(particles.sorted + t.a).filter;
    float furthest = 0;
    for (uint32_t k = set.fixed; k < set.of_world(); ++k) {
      const Shape& shape = set.shapes[set.number(k, world)];
      if (shape.kind == ShapeKind::plane || !collide(shape, filter)) continue;
      if (touches.is_face_attached(t, shape.body)) continue;
      for (const uint32_t v : {t.a, t.b, t.c})
        furthest = pbd::max(furthest, motion_beside(shape.body, v, size[t.piece]));
    }
    const float substeps = ceilf(furthest / (zone_tuning::most_motion * size[t.piece]));
    if (substeps > 1) pbd::atomic_max(needed[world], static_cast<uint32_t>(pbd::min(substeps, 1e6f)));
  }

 private:
  /// m: the motion of a body relative to a vertex that may come near it; 0 for others.
  MENISCUS_HD float motion_beside(uint32_t body, uint32_t vertex, float margin) const {
    const RigidMotion& m = motion[body];
    const uint32_t i = particles.sorted + vertex;
    const Vec3 from = particles.position[i].xyz() - m.start.position;
    const Vec3 path = dt * (particles.velocity[i].xyz() - m.velocity);
    const float along = -dot(from, path), whole = dot(path, path);
    const float t = along <= 0 ? 0.0f : along < whole ? along / whole : 1.0f;
    const float near = reach[body] + zone_tuning::surroundings * margin;
    if (!(squared_length(from + t * path) < near * near)) return 0;
    return sqrtf(whole) + dt * (length(m.angular_velocity) * reach[body] + dt * acceleration[body]);
  }
};

/// The rigid motion of a zone over the substep.
struct ZoneMotion {
  Vec3 centre{0, 0, 0};  ///< m, at the substep's start
  Vec3 shift{0, 0, 0};   ///< m, of the centre
  Vec3 turn{0, 0, 0};    ///< rad

  MENISCUS_HD Vec3 displacement(Vec3 from) const {
    const Vec3 arm = from - centre;
    return shift + (rotate(rotation_by(turn), arm) - arm);
  }
  MENISCUS_HD Pose applied(const Pose& from) const {
    return {from.position + displacement(from.position), normalized(rotation_by(turn) * from.rotation)};
  }
};

/// The state of all zones.
struct Zones {
  View<uint32_t> label;       ///< by body: union-find
  View<uint32_t> grown;       ///< by body: the last round, counted from 1, in which its zone got a member
  View<uint32_t> anchor;      ///< by body: what holds its zone, see anchor_of()
  View<ZoneMotion> motion;    ///< by body that names a zone
  View<Pose> pose;            ///< by body: where it will be at the substep's end
  View<Vec3> turn;            ///< by body: rad, over the substep
  View<uint32_t> zone_of;     ///< by vertex: a body of its zone, or no_index
  View<uint32_t> piece_zone;  ///< by piece, if all of it has joined a zone: a body of that
  View<uint32_t> crossings;   ///< by round and world
  uint32_t worlds, bodies, vertices;  ///< bodies and vertices: of a world

  MENISCUS_HD uint32_t name(uint32_t body) const { return pbd::UnionFind{label}.name(body); }
  MENISCUS_HD bool is_zone(uint32_t body) const { return grown[name(body)] != 0; }

  /// The crossings that a round has found in a world.
  MENISCUS_HD uint32_t& crossings_in(uint32_t round, uint32_t world) const {
    return crossings.data[round * worlds + world];
  }
  MENISCUS_HD bool crosses_body(uint32_t round, uint32_t b) const {
    return crossings_in(round, b / bodies) != 0;
  }
  MENISCUS_HD bool crosses_vertex(uint32_t round, uint32_t v) const {
    return crossings_in(round, v / vertices) != 0;
  }

  /// An immovable body as the anchor of its zone. Vertices that nothing moves come after all bodies.
  MENISCUS_HD uint32_t anchor_of(uint32_t vertex) const { return label.count + vertex; }

  MENISCUS_HD void join(uint32_t& member, uint32_t body) const {
    const uint32_t before = pbd::atomic_exchange_if(member, no_index, body);
    if (before != no_index && before != body) pbd::UnionFind{label}.unite(before, body);
  }
};

/// What the bodies' contacts have given them so far in the substep.
struct BodyState {
  View<const BodyProxy> bodies;
  View<const RigidMotion> motion;
  View<const ContactSum> partial;
  uint32_t lanes;
  float dt;

  MENISCUS_HD ContactSum sum(uint32_t b) const {
    return bodies[b].first == bodies[b].end ? ContactSum{} : sum_of_lanes(partial, b, lanes);
  }
  /// The displacement, m, and the turn, rad, over the substep. Both are linear in the impulses, as Bullet
  /// integrates them.
  MENISCUS_HD Vec3 shift(uint32_t b, const ContactSum& sum) const {
    return dt * motion[b].velocity - bodies[b].inverse_mass * sum.push.xyz();
  }
  MENISCUS_HD Vec3 turn(uint32_t b, const ContactSum& sum) const {
    return dt * motion[b].angular_velocity - at_start(b, sum.twist.xyz(), bodies[b].inverse_inertia);
  }
  /// A principal tensor, in the axes that the body has at the substep's start, times a vector.
  MENISCUS_HD Vec3 at_start(uint32_t b, Vec3 v, Vec3 principal) const {
    const Quat axes = bodies[b].start.rotation;
    const Vec3 local = rotate(conjugate(axes), v);
    return rotate(axes, {principal.x * local.x, principal.y * local.y, principal.z * local.z});
  }
  MENISCUS_HD bool turns(uint32_t b) const { return -max_component(-bodies[b].inverse_inertia) > 0; }
  MENISCUS_HD Vec3 inertia(uint32_t b) const {
    const Vec3 i = bodies[b].inverse_inertia;
    return {1 / i.x, 1 / i.y, 1 / i.z};
  }
};

struct Begin {
  Zones zones;
  BodyState state;

  MENISCUS_HD void operator()(uint32_t n) const {
    if (n < zones.crossings.count) zones.crossings[n] = 0;
    if (n < zones.piece_zone.count) zones.piece_zone[n] = no_index;
    if (n < zones.zone_of.count) zones.zone_of[n] = no_index;
    if (n >= zones.label.count) return;
    zones.label[n] = n;
    zones.grown[n] = 0;
    zones.anchor[n] = state.bodies[n].inverse_mass > 0 ? no_index : n;
    const ContactSum sum = state.sum(n);
    zones.turn[n] = state.turn(n, sum);
    zones.pose[n] = displaced(state.bodies[n].start, state.shift(n, sum), zones.turn[n]);
  }
};

/// Finds the faces that a body would pass. Unites them and the body in a zone. In the last round all of their
/// piece joins.
struct FindPassing {
  Zones zones;
  ShapeSet set;
  shape_contact_kernels::Touches touches;
  View<const SurfaceTriangle> triangles;
  ParticleView particles;
  View<const BodyProxy> bodies;
  View<uint32_t> found;  ///< one element, for the host
  uint32_t round;
  bool last;

  MENISCUS_HD void operator()(uint32_t n) const {
    const uint32_t world = n / (triangles.count / set.worlds);
    if (round > 0 && zones.crossings_in(round - 1, world) == 0) return;
    const SurfaceTriangle t = triangles[n];
    const FaceMotion motion = face_kernels::motion_of(particles, t);
    const Aabb box = face_kernels::bounds_of(motion);
    if (!is_finite(box.lower) || !is_finite(box.upper) || overlapped(t)) return;
    const Touch touch = touches.of(particles.sorted + t.a);
    for (uint32_t k = set.fixed; k < set.of_world(); ++k) {
      const Shape& shape = set.shapes[set.number(k, world)];
      if (shape.kind == ShapeKind::plane) continue;
      // The bounds are those of the predicted motion.
      const float astray = length(zones.pose[shape.body].position - bodies[shape.body].pose.position);
      if (out_of_reach(shape, box.lower, box.upper, touch.radius + astray)) continue;
      if (!collide(shape, touch.filter) || touches.is_face_attached(t, shape.body)) continue;
      if (passes(shape, motion, touch.radius)) join(t, shape.body, world);
    }
  }

 private:
  MENISCUS_HD bool overlapped(const SurfaceTriangle& t) const {
    const uint32_t s = particles.sorted;
    return touches.may_overlap(s + t.a) || touches.may_overlap(s + t.b) || touches.may_overlap(s + t.c);
  }

  /// Whether the face comes too near on its way, by conservative advancement in the frame of the shape. The
  /// paths of vertices are straight there. So faces that share a vertex agree on its path.
  MENISCUS_HD bool passes(const Shape& shape, const FaceMotion& world, float radius) const {
    const Pose carried = inverse(bodies[shape.body].pose) * shape.pose;
    const FaceMotion m{face_kernels::in_frame(world.from, shape.start),
                       face_kernels::in_frame(world.to, zones.pose[shape.body] * carried)};
    const float displacement = displacement_of(m), least = zone_tuning::least * radius;
    if (displacement < 0.5f * least) return false;
    const FaceField field{set, shape, radius_of(m.from) + displacement + least};
    constexpr float third = 1.0f / 3;
    const float from_centre = field.at(m.from, {third, third, third}).surface.distance;
    if (from_centre > field.reach) return false;
    const float tolerance = face_tuning::advance_tolerance * least;
    const float at_start = field.nearest(m.from, tolerance).surface.distance;
    if (at_start <= 0) return false;
    const float gap = pbd::min(least, zone_tuning::kept * at_start);
    float t = (at_start - 0.5f * gap) / displacement;
    for (int k = 0; k < zone_tuning::advance_steps && t < 1; ++k) {
      const float distance = field.nearest(between(m, t), tolerance).surface.distance;
      if (distance < gap) return true;
      t += (distance - 0.5f * gap) / displacement;
    }
    return t < 1 || field.nearest(m.to, tolerance).surface.distance < gap;
  }

  MENISCUS_HD void join(const SurfaceTriangle& t, uint32_t body, uint32_t world) const {
    pbd::atomic_max(found[0], 1);
    if (zones.zone_of.count == 0) return;
    pbd::atomic_add(zones.crossings_in(round, world), 1);
    pbd::atomic_max(zones.grown[body], round + 1);
    for (const uint32_t v : {t.a, t.b, t.c}) zones.join(zones.zone_of[v], body);
    if (last) zones.join(zones.piece_zone[t.piece], body);
  }
};

}  // namespace meniscus::collision::zone_kernels
