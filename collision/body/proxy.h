// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Rigid bodies as kernels read them: proxies that are predicted with the particles, and that particles push
// within the iterations. The result goes to the rigid world as an impulse.
#pragma once

#include "collision/contact/shape.h"
#include "collision/rigid/rigid_motion.h"
#include "pbd/contacts.h"
#include "pbd/math/matrix.h"

namespace meniscus::collision {

struct BodyProxy {
  Pose start, pose;  ///< at the substep's start; and predicted for its end
  float inverse_mass;
  Vec3 inverse_inertia;  ///< principal
  uint32_t first, end;   ///< the range of its contacts, in the order grouped by body
  uint32_t unyielding;   ///< the first of its contacts with what cannot yield
  uint32_t attached;     ///< the first of its attachments, which come last
  Vec3 loaded{0, 0, 0};  ///< see RigidMotion
  float yielding = 1;
  bool is_held = false;  ///< fluid sees it move as held_kernels.h says
};

/// What other solids leave of a push, as far as the body gives way to it.
MENISCUS_HD inline Vec3 resisted_push(const BodyProxy& body, Vec3 push) {
  if (body.yielding == 1) return push;
  return push - ((1 - body.yielding) * dot(push, body.loaded)) * body.loaded;
}

/// Likewise of a torque or a turn. Applied on both sides of I⁻¹, so that the product stays symmetric.
MENISCUS_HD inline Vec3 resisted_turn(const BodyProxy& body, Vec3 turn) {
  if (body.yielding == 1) return turn;
  const Vec3 about = dot(turn, body.loaded) * body.loaded;
  return about + sqrtf(body.yielding) * (turn - about);
}

/// I⁻¹ t in world axes.
MENISCUS_HD inline Vec3 inverse_inertia_times(const BodyProxy& body, Vec3 t) {
  const Vec3 local = rotate(conjugate(body.pose.rotation), t), i = body.inverse_inertia;
  return rotate(body.pose.rotation, {i.x * local.x, i.y * local.y, i.z * local.z});
}

/// 1/M + (r × n)ᵀ I⁻¹ (r × n): the inverse mass of the point at r along n, 1/kg. Solids that load the body
/// are included.
MENISCUS_HD inline float inverse_mass_at(const BodyProxy& body, Vec3 r, Vec3 n) {
  const Vec3 lever = resisted_turn(body, cross(r, n));
  const float along = dot(n, body.loaded), left = 1 - (1 - body.yielding) * along * along;
  return left * body.inverse_mass + dot(lever, inverse_inertia_times(body, lever));
}

/// The same without other solids.
MENISCUS_HD inline float unloaded_inverse_mass_at(const BodyProxy& body, Vec3 r, Vec3 n) {
  const Vec3 lever = cross(r, n);
  return body.inverse_mass + dot(lever, inverse_inertia_times(body, lever));
}

/// 1/M + [r]ᵀ I⁻¹ [r]: the inverse mass matrix of the point at r, 1/kg.
MENISCUS_HD inline Sym3 inverse_mass_matrix(const BodyProxy& body, Vec3 r) {
  const Mat3 lever = cross_matrix(rotate(conjugate(body.pose.rotation), r), 0);
  const Sym3 local = symmetric_product(times_diagonal(lever, body.inverse_inertia), lever);
  return turned(rotation_matrix(body.pose.rotation), local) + diagonal(body.inverse_mass);
}

/// The maximum of inverse_mass_at over all directions. [r]ᵀ I⁻¹ [r] has the eigenvalue 0 along r. The sum of
/// the two others is its trace, and their product is |r|² rᵀ adj(I⁻¹) r.
MENISCUS_HD inline float largest_inverse_mass_at(const BodyProxy& body, Vec3 r) {
  const Vec3 local = rotate(conjugate(body.pose.rotation), r), i = body.inverse_inertia;
  const Vec3 s{local.x * local.x, local.y * local.y, local.z * local.z};
  const float mean = 0.5f * (i.x * (s.y + s.z) + i.y * (s.x + s.z) + i.z * (s.x + s.y));
  const float product = (s.x + s.y + s.z) * (s.x * i.y * i.z + s.y * i.x * i.z + s.z * i.x * i.y);
  return body.inverse_mass + mean + sqrtf(pbd::max(0.0f, mean * mean - product));
}

/// Where a body gets to: the same map as Bullet's (btTransformUtil::integrateTransform).
MENISCUS_HD inline Pose displaced(const Pose& from, Vec3 shift, Vec3 turn) {
  return {from.position + shift, normalized(rotation_by(turn) * from.rotation)};
}

/// A shape that a body carries, in the body's frame.
struct CarriedShape {
  uint32_t shape = 0;
  uint32_t body = 0;
  Pose pose;
  Aabb bounds{{0, 0, 0}, {0, 0, 0}};  ///< of the solid, in the shape's frame
  Vec3 normal{0, 1, 0};               ///< plane, in the shape's frame
  float offset = 0;                   ///< plane, likewise
};

/// World box of a box under a pose.
MENISCUS_HD inline Aabb world_box(const Pose& pose, const Aabb& local) {
  const Vec3 centre = to_world(pose, 0.5f * (local.lower + local.upper));
  const Vec3 half = 0.5f * (local.upper - local.lower);
  const Vec3 reach = abs(rotate(pose.rotation, {half.x, 0, 0})) + abs(rotate(pose.rotation, {0, half.y, 0})) +
                     abs(rotate(pose.rotation, {0, 0, half.z}));
  return {centre - reach, centre + reach};
}

/// The poses of a body at the substep's start and at its end.
struct BodyEnds {
  Pose start, pose;
};

/// Places a shape at both ends of the substep.
MENISCUS_HD inline void carry(const CarriedShape& carried, const BodyEnds& body, Shape& shape) {
  shape.start = body.start * carried.pose;
  shape.pose = body.pose * carried.pose;
  shape.size = shape.kind == ShapeKind::plane ? rotate(shape.pose.rotation, carried.normal) : shape.size;
  if (shape.kind == ShapeKind::plane) {
    shape.offset = carried.offset + dot(shape.size, shape.pose.position);
    return;
  }
  const Aabb from = world_box(shape.start, carried.bounds), to = world_box(shape.pose, carried.bounds);
  // During a turn the shape may leave both boxes, by no more than the sagitta of the outermost point's arc.
  const Vec3 far = max(abs(carried.bounds.lower), abs(carried.bounds.upper)) + abs(carried.pose.position);
  const Quat turn = body.pose.rotation * conjugate(body.start.rotation);
  const float sine2 = turn.x * turn.x + turn.y * turn.y + turn.z * turn.z;  // sin² of half the angle
  const float bulge = length(far) * (1 - sqrtf(pbd::max(0.0f, 1 - sine2)));
  const Vec3 room{bulge, bulge, bulge};
  shape.bounds = {min(from.lower, to.lower) - room, max(from.upper, to.upper) + room};
}

}  // namespace meniscus::collision
