// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Joints, as Bullet's constraints. None of them has state from one step to the next.
#include <algorithm>
#include <cassert>
#include <cmath>

#include "collision/rigid/columns.h"
#include "collision/rigid/rigid_impl.h"
#include "pbd/math/vec.h"

namespace meniscus::collision {

namespace {

/// The joint's frame in each of the two bodies.
struct Frames {
  btRigidBody &a, &b;
  btTransform in_a, in_b;
};

/// `turn` rotates the axis that Bullet uses to y.
Frames frames_of(btRigidBody& a, btRigidBody& b, const Pose& frame, const btQuaternion& turn) {
  const btTransform world = to_bullet(frame) * btTransform(turn);
  return {a, b, a.getWorldTransform().inverse() * world, b.getWorldTransform().inverse() * world};
}

const btQuaternion z_to_y{{1, 0, 0}, -SIMD_HALF_PI};
const btQuaternion x_to_y{{0, 0, 1}, SIMD_HALF_PI};

using Constraint = std::unique_ptr<btTypedConstraint>;

auto make_axes(const Frames& f) {
  auto made = std::make_unique<btGeneric6DofSpring2Constraint>(f.a, f.b, f.in_a, f.in_b);
  for (int axis = 0; axis < 6; ++axis) made->setLimit(axis, 0, 0);
  return made;
}

Constraint make_slider(const Frames& f, const SliderJoint& slider) {
  auto made = make_axes(f);
  if (slider.lower) {
    made->setLimit(0, *slider.lower, *slider.upper);
  } else {
    made->setLimit(0, 1, -1);  // lower limit above the upper one: free
  }
  if (slider.motor_force > 0) {
    made->enableMotor(0, true);
    made->setTargetVelocity(0, -slider.motor_speed);  // Bullet's is of a along b
    made->setMaxMotorForce(0, slider.motor_force / mass_unit);
  }
  return made;
}

Constraint make_springs(const Frames& f, const SpringJoint& spring) {
  auto made = make_axes(f);
  const Vec3 k[2] = {spring.stiffness, spring.angular_stiffness};
  const Vec3 c[2] = {spring.damping, spring.angular_damping};
  for (int axis = 0; axis < 6; ++axis) {
    const btVector3 stiffness = to_bullet(k[axis / 3]), damping = to_bullet(c[axis / 3]);
    if (std::isinf(stiffness[axis % 3])) continue;
    made->setLimit(axis, 1, -1);
    if (stiffness[axis % 3] <= 0) continue;
    made->enableSpring(axis, true);
    made->setStiffness(axis, stiffness[axis % 3] / mass_unit);
    made->setDamping(axis, damping[axis % 3] / mass_unit);
    made->setEquilibriumPoint(axis, 0);
    made->setUserConstraintType(spring_constraint);
  }
  return made;
}

std::unique_ptr<btHingeConstraint> make_hinge(const Frames& f, const HingeJoint& hinge) {
  auto made = std::make_unique<btHingeConstraint>(f.a, f.b, f.in_a, f.in_b, true);
  if (hinge.lower) made->setLimit(*hinge.lower, *hinge.upper);
  if (hinge.motor_torque > 0) made->enableAngularMotor(true, hinge.motor_speed, 0);
  return made;
}

void make_constraint(RigidJointRecord& joint, btRigidBody& a, btRigidBody& b, const RigidJointDef& def) {
  if (const auto* hinge = std::get_if<HingeJoint>(&def.kind)) {
    auto made = make_hinge(frames_of(a, b, def.frame, z_to_y), *hinge);
    joint.hinge = made.get();
    joint.motor_torque = hinge->motor_torque;
    joint.has_motor = hinge->motor_torque > 0;
    joint.bullet = std::move(made);
  } else if (const auto* slider = std::get_if<SliderJoint>(&def.kind)) {
    joint.has_motor = slider->motor_force > 0;
    joint.bullet = make_slider(frames_of(a, b, def.frame, x_to_y), *slider);
  } else if (const auto* spring = std::get_if<SpringJoint>(&def.kind)) {
    joint.bullet = make_springs(frames_of(a, b, def.frame, btQuaternion::getIdentity()), *spring);
  } else {
    const Frames f = frames_of(a, b, def.frame, btQuaternion::getIdentity());
    if (std::holds_alternative<BallJoint>(def.kind)) {
      joint.bullet = std::make_unique<btPoint2PointConstraint>(a, b, f.in_a.getOrigin(), f.in_b.getOrigin());
    } else {
      joint.bullet = make_axes(f);
    }
  }
}

/// Takes the memory that another number in the list needs.
void make_room(std::vector<uint32_t>& numbers) {
  if (numbers.size() == numbers.capacity()) numbers.reserve(2 * numbers.size() + 1);
}

void note(std::vector<uint32_t>& numbers, uint32_t number) {
  numbers.insert(std::ranges::lower_bound(numbers, number), number);
}

void forget(std::vector<uint32_t>& numbers, uint32_t number) {
  numbers.erase(std::ranges::lower_bound(numbers, number));
}

}  // namespace

uint32_t RigidWorld::Impl::make_joint(const RigidJointDef& joint, uint32_t number) {
  joints.prepare();
  make_room(body(joint.a).joints);
  if (joint.b != pbd::no_index) make_room(body(joint.b).joints);
  btRigidBody& a = *body(joint.a).bullet;
  btRigidBody& b = joint.b == pbd::no_index ? ground : *body(joint.b).bullet;
  auto made = std::make_unique<RigidJointRecord>();
  made->a = joint.a;
  made->b = joint.b;
  std::ranges::copy(to_plain(a.getWorldTransform()), made->places.a);
  std::ranges::copy(to_plain(b.getWorldTransform()), made->places.b);
  make_constraint(*made, a, b, joint);
  dynamics.add_joint(*made->bullet);
  if (!joint.bodies_collide) a.addConstraintRef(made->bullet.get());
  if (!joint.bodies_collide && joint.b != pbd::no_index) {
    b.addConstraintRef(made->bullet.get());
    // Otherwise their present contacts would go on pushing.
    btBroadphasePair* pair = pairs.findPair(a.getBroadphaseHandle(), b.getBroadphaseHandle());
    if (pair) pairs.cleanOverlappingPair(*pair, &dispatcher);
    dispatcher.note_disorder();
  }
  wake_up(a);
  if (joint.b != pbd::no_index) wake_up(b);
  number = joints.add_at(number, std::move(made));
  note(body(joint.a).joints, number);
  if (joint.b != pbd::no_index) note(body(joint.b).joints, number);
  return number;
}

uint32_t RigidWorld::add_joint(const RigidJointDef& def) {
  if (impl_->def.on_device) refuse_joint();
  const InBullet bullet(*reserve_, impl_->size());
  return impl_->make_joint(def, pbd::no_index);
}

void RigidWorld::add_joint(const RigidJointDef& def, uint32_t number, const JointPlaces& places) {
  const InBullet bullet(*reserve_, impl_->size());
  const auto place = [&](uint32_t body, const float(&at)[12]) {
    if (body == pbd::no_index) return;
    PlainTransform plain;
    std::ranges::copy(at, plain.begin());
    btTransform transform;
    from_plain(plain, transform);
    impl_->body(body).bullet->setWorldTransform(transform);
  };
  place(def.a, places.a);
  place(def.b, places.b);
  impl_->make_joint(def, number);
}

void RigidWorld::remove_joint(uint32_t number) {
  assert(has_joint(number));
  const InBullet bullet(*reserve_, impl_->size());
  impl_->remove_joint(number);
}

void RigidWorld::Impl::remove_joint(uint32_t number) {
  const RigidJointRecord& joint = *joints.slots[number];
  joint.bullet->getRigidBodyA().activate();
  joint.bullet->getRigidBodyB().activate();
  dynamics.remove_joint(*joint.bullet);
  for (const uint32_t n : {joint.a, joint.b})
    if (n != pbd::no_index) forget(bodies.slots[n]->joints, number);
  joints.remove(number);
}

bool RigidWorld::has_joint(uint32_t number) const {
  return impl_->joints.has(number);
}

float RigidWorld::hinge_angle(uint32_t number) const {
  assert(has_joint(number));
  btHingeConstraint* hinge = impl_->joints.slots[number]->hinge;
  return hinge ? hinge->getHingeAngle() : 0;
}

/// Bullet bounds a hinge's motor by an impulse, so the bound depends on the step.
void RigidWorld::Impl::limit_motors(float dt) {
  for (const auto& joint : joints.slots) {
    if (joint && joint->hinge) joint->hinge->setMaxMotorImpulse(joint->motor_torque / mass_unit * dt);
  }
}

}  // namespace meniscus::collision
