// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Bullet's headers for the files of RigidWorld, and conversions to and from Bullet's types. Bullet is that of
// the distribution, in single precision.
#pragma once

#include <BulletCollision/BroadphaseCollision/btAxisSweep3.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <btBulletDynamicsCommon.h>
#include <meniscus/types.h>

namespace meniscus::collision {

inline btVector3 to_bullet(Vec3 v) {
  return {v.x, v.y, v.z};
}
inline btQuaternion to_bullet(Quat q) {
  return {q.x, q.y, q.z, q.w};
}
inline btTransform to_bullet(const Pose& pose) {
  return btTransform(to_bullet(pose.rotation), to_bullet(pose.position));
}

/// Unit of mass for Bullet, kg. Bullet takes inverse masses and inertias below its epsilon as 0. In kilograms
/// a body of 1.4e7 would fall through others. A power of two keeps the bits of the mantissa.
inline constexpr float mass_unit = 0x1p20f;

/// Converts a moment of inertia, a force, a torque or an impulse.
inline btVector3 in_mass_units(const btVector3& v) {
  return v / mass_unit;
}
inline btVector3 in_mass_units(Vec3 v) {
  return in_mass_units(to_bullet(v));
}

inline Vec3 from_bullet(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}
inline Pose from_bullet(const btTransform& t) {
  const btQuaternion q = t.getRotation();
  return {from_bullet(t.getOrigin()), {q.x(), q.y(), q.z(), q.w()}};
}

}  // namespace meniscus::collision
