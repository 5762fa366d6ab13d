// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Functions of BodyCalls.
#include "sdk/world/state/body_calls.h"

#include <meniscus/error.h>

#include <algorithm>
#include <string>

#include "sdk/world/check/check.h"

namespace meniscus {

namespace {

void expect_motion(const BodyEntry& entry, BodyMotion motion, const char* call, const char* kind) {
  if (entry.def.motion == motion) return;
  throw Error(ErrorCode::invalid_argument, std::string(call) + " is for " + kind + " bodies alone");
}

/// Refuses a value from which a body's force or torque is no longer finite. Steps would fail for ever.
void expect_finite_sum(const char* name, Vec3 value, Vec3 sum) {
  if (!is_finite(sum))
    check::refuse(name, check::text_of(value), "such that all forces on the body sum up to finite ones");
}

/// Refuses a point so far off that an impulse there turns the body by more than 1e9 rad/s: the squares of
/// what steps make of it are still finite.
void expect_finite_turn(const char* name, Vec3 point, Vec3 angular_impulse, Vec3 inertia) {
  constexpr float most = 1e9f;
  if (length(angular_impulse) <= most * std::min({inertia.x, inertia.y, inertia.z})) return;
  check::refuse(name, check::text_of(point), "such that the impulse turns the body by at most 1e9 rad/s");
}

}  // namespace

BodyState BodyCalls::state(const collision::RigidImpulse& force) const {
  return {rigid.pose(number),     rigid.centre_of_mass(number),
          rigid.velocity(number), rigid.angular_velocity(number),
          force.linear,           force.angular,
          rigid.awake(number)};
}

void BodyCalls::set_velocity(Vec3 velocity, Vec3 angular_velocity) const {
  expect_motion(entry, BodyMotion::dynamic, "set_body_velocity", "dynamic");
  check::value("set_body_velocity's velocity", velocity);
  check::value("set_body_velocity's angular_velocity", angular_velocity);
  rigid.set_velocity(number, velocity, angular_velocity);
}

void BodyCalls::apply_force(Vec3 force, Vec3 point) const {
  expect_motion(entry, BodyMotion::dynamic, "apply_force", "dynamic");
  check::value("apply_force's force", force);
  check::value("apply_force's point", point);
  const collision::RigidImpulse sums = rigid.pending(number);
  expect_finite_sum("apply_force's force", force, sums.linear + force);
  expect_finite_sum("apply_force's point", point,
                    sums.angular + cross(point - rigid.centre_of_mass(number), force));
  rigid.apply_force(number, force, point);
}

void BodyCalls::apply_torque(Vec3 torque) const {
  expect_motion(entry, BodyMotion::dynamic, "apply_torque", "dynamic");
  check::value("apply_torque's torque", torque);
  expect_finite_sum("apply_torque's torque", torque, rigid.pending(number).angular + torque);
  rigid.apply_torque(number, torque);
}

void BodyCalls::apply_impulse(Vec3 impulse, Vec3 point) const {
  expect_motion(entry, BodyMotion::dynamic, "apply_impulse", "dynamic");
  check::impulse("apply_impulse's impulse", impulse, entry.mass.mass);
  check::value("apply_impulse's point", point);
  expect_finite_turn("apply_impulse's point", point, cross(point - rigid.centre_of_mass(number), impulse),
                     entry.mass.inertia);
  rigid.apply_impulse(number, impulse, point);
}

void BodyCalls::move(const Pose& target, float duration) const {
  expect_motion(entry, BodyMotion::kinematic, "move_body", "kinematic");
  check::value("move_body's target", target);
  check::value("move_body's duration", duration, positive, "s");
  rigid.move(number, target, duration);
}

}  // namespace meniscus
