// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Motion of a rigid world: impulses and steps. The prediction is in predict.cpp.
#include <meniscus/error.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "collision/rigid/rigid_impl.h"
#include "collision/rigid/tuning.h"
#include "pbd/math/vec.h"

namespace meniscus::collision {

namespace {

bool is_sprung(btRigidBody& body) {
  for (int i = 0; i < body.getNumConstraintRefs(); ++i) {
    if (body.getConstraintRef(i)->getUserConstraintType() == spring_constraint) return true;
  }
  return false;
}

/// Applies the push of particles, unless the body sleeps through it.
void take_impulse(RigidBodyRecord& body, const RigidImpulse& impulse, float dt, float gravity,
                  bool on_device) {
  RigidMemory& memory = body.memory;
  const Vec3 force = impulse.linear / dt, torque = impulse.angular / dt;
  const float weight = gravity * mass_unit / body.bullet->getInvMass();
  if (!body.bullet->isActive()) {
    const bool as_usual =
        length(force - memory.usual_force) <= rigid_tuning::waking_change * weight &&
        length(torque - memory.usual_torque) <= rigid_tuning::waking_change * weight * body.shape.radius;
    if (as_usual) return;
    wake_up(*body.bullet);
  }
  const float fraction = dt / (rigid_tuning::smoothing_time + dt);
  memory.usual_force += fraction * (force - memory.usual_force);
  memory.usual_torque += fraction * (torque - memory.usual_torque);
  if (on_device || is_sprung(*body.bullet)) {
    // On a device contacts meet it in small steps, and a light body that carries a heavy one is not thrown.
    // As motion before the joint solve, the push would be resisted by a damper for ever.
    body.push = force;
    body.push_torque = torque;
  } else {
    body.bullet->applyCentralImpulse(in_mass_units(impulse.linear));
    body.bullet->applyTorqueImpulse(in_mass_units(impulse.angular));
  }
}

}  // namespace

KinematicVelocity velocity_to(const Pose& start, const Pose& target, float dt) {
  return {(target.position - start.position) / dt, turn_between(start.rotation, target.rotation) / dt};
}

Pose RigidWorld::Impl::kinematic_pose(const RigidBodyRecord& body, double at) const {
  switch (body.memory.drive) {
    case KinematicDrive::keyframes:
      return keyframe_pose(body.keyframes, body.loop, at);
    case KinematicDrive::move:
      return move_pose(body.memory.move, at);
    case KinematicDrive::still:
      break;
  }
  return body.memory.pose;
}

void RigidWorld::Impl::place_kinematic(RigidBodyRecord& body, const Pose& pose) {
  body.memory.pose = pose;
  const btTransform at = to_bullet(pose) * to_bullet(body.shape.frame);
  body.bullet->setWorldTransform(at);
  body.bullet->setInterpolationWorldTransform(at);
}

void RigidWorld::Impl::take_impulses(float dt, std::span<const RigidImpulse> impulses) {
  assert(impulses.empty() || impulses.size() >= bodies.slots.size());
  for (uint32_t n = 0; n < bodies.slots.size(); ++n) {
    if (!bodies.has(n) || bodies.slots[n]->kinematic) continue;
    bodies.slots[n]->push = bodies.slots[n]->push_torque = {0, 0, 0};
    if (!impulses.empty())
      take_impulse(*bodies.slots[n], impulses[n], dt, acceleration_scale(), def.on_device);
  }
}

/// Gives kinematic bodies the velocities that take them from their poses to their targets.
void RigidWorld::Impl::drive_kinematics(float dt) {
  for (const auto& body : bodies.slots) {
    if (!body || !body->kinematic) continue;
    body->from = body->memory.pose;
    body->to = kinematic_pose(*body, time + dt);
    const Pose& frame = body->shape.frame;
    const KinematicVelocity v = velocity_to(body->from * frame, body->to * frame, dt);
    set_speed(*body->bullet, v.linear, v.angular);
    // A body at rest may sleep, so that what lies on it may sleep too.
    if (!(v.linear == Vec3{0, 0, 0} && v.angular == Vec3{0, 0, 0})) wake_up(*body->bullet);
  }
}

/// Contacts wake bodies that lie on a moving body. Bodies that hang from it by a joint are woken here.
void RigidWorld::Impl::wake_driven() {
  const auto moves = [&](uint32_t n) {
    if (!bodies.has(n) || !bodies.slots[n]->kinematic) return false;
    const btRigidBody& body = *bodies.slots[n]->bullet;
    return !body.getLinearVelocity().isZero() || !body.getAngularVelocity().isZero();
  };
  for (const auto& joint : joints.slots) {
    if (!joint) continue;
    if (moves(joint->a) && bodies.has(joint->b)) wake_up(*bodies.slots[joint->b]->bullet);
    if (moves(joint->b) && bodies.has(joint->a)) wake_up(*bodies.slots[joint->a]->bullet);
  }
}

/// A motor may press a body against particles. Asleep, the body would not yield to what they do.
void RigidWorld::Impl::keep_motors_awake() {
  for (const auto& joint : joints.slots) {
    if (!joint || !joint->has_motor) continue;
    for (const uint32_t n : {joint->a, joint->b})
      if (bodies.has(n)) bodies.slots[n]->bullet->setDeactivationTime(0);
  }
}

void RigidWorld::Impl::advance_kinematics(float fraction) {
  for (const auto& body : bodies.slots) {
    if (!body || !body->kinematic) continue;
    place_kinematic(*body, fraction < 1 ? between(body->from, body->to, fraction) : body->to);
  }
}

void RigidWorld::Impl::apply_forces(float dt) {
  for (const auto& body : bodies.slots) {
    if (!body || body->kinematic) continue;
    btRigidBody& bullet = *body->bullet;
    if (body->kept_awake) bullet.setDeactivationTime(0);
    bullet.clearForces();
    bullet.applyCentralForce(in_mass_units(body->memory.force + body->push));
    bullet.applyTorque(in_mass_units(body->memory.torque + body->push_torque));
    if (bullet.isActive()) bullet.setAngularVelocity(tumbled(bullet, bullet.getAngularVelocity(), dt));
  }
}

void RigidWorld::begin_step(float dt) {
  const InBullet bullet(*reserve_, impl_->size());
  impl_->knows_touches = false;
  impl_->drive_kinematics(dt);
  impl_->wake_driven();
  if (impl_->def.on_device) return impl_->begin_on_device(dt / static_cast<float>(impl_->def.substeps));
  impl_->dynamics.detect(dt / static_cast<float>(impl_->def.substeps));
}

void RigidWorld::finish_step(float dt, std::span<const RigidImpulse> impulses) {
  const InBullet bullet(*reserve_, impl_->size());
  Impl& world = *impl_;
  const int substeps = world.def.substeps;
  const float h = dt / static_cast<float>(substeps);
  world.knows_touches = false;
  world.take_impulses(dt, impulses);
  world.limit_motors(h);
  world.dynamics.getSolverInfo().m_restitutionVelocityThreshold =
      rigid_tuning::resting_steps * h * length(world.def.gravity);
  for (int i = 1; i <= substeps; ++i) {
    if (world.def.on_device) {
      world.step_on_device(h, i == 1);
    } else {
      if (i > 1) world.dynamics.detect(h);
      world.keep_motors_awake();
      world.apply_forces(h);
      world.dynamics.advance(h);
    }
    world.advance_kinematics(i < substeps ? static_cast<float>(i) / static_cast<float>(substeps) : 1);
  }
  world.time += dt;
}

void RigidWorld::check_finite() const {
  for (uint32_t n = 0; n < body_slots(); ++n) {
    if (!impl_->bodies.has(n)) continue;
    const btRigidBody& body = *impl_->body(n).bullet;
    const btTransform& at = body.getWorldTransform();
    btVector3 all = at.getOrigin();
    for (int row = 0; row < 3; ++row) all += at.getBasis().getRow(row);
    // As for particles, the squares of speeds must be finite as well.
    const float squares = body.getLinearVelocity().length2() + body.getAngularVelocity().length2();
    if (is_finite(from_bullet(all)) && std::isfinite(squares)) continue;
    const std::string& name = impl_->body(n).name;
    const std::string which = name.empty() ? "with the index " + std::to_string(n) : "\"" + name + "\"";
    throw Error(ErrorCode::non_finite, "the rigid body " + which +
                                           " became non-finite; the state is the one before the step. More "
                                           "of RigidSolverDef::substeps may help");
  }
}

void RigidWorld::set_time(double time) {
  assert(body_count() == 0);
  impl_->time = time;
}

void RigidWorld::end_step() {
  for (auto& body : impl_->bodies.slots) {
    if (body) body->memory.force = body->memory.torque = {0, 0, 0};
  }
}

void RigidWorld::move(uint32_t number, const Pose& target, float duration) {
  RigidBodyRecord& body = impl_->body(number);
  assert(body.kinematic);
  body.memory.move = {body.memory.pose, target, impl_->time, duration};
  body.memory.drive = KinematicDrive::move;
}

}  // namespace meniscus::collision
