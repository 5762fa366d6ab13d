// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The prediction of bodies' motions: with the forces and joints that Bullet will integrate, and without
// contacts.
#include <algorithm>
#include <cassert>
#include <cmath>

#include "collision/rigid/rigid_impl.h"
#include "collision/rigid/tuning.h"
#include "pbd/math/vec.h"

namespace meniscus::collision {

namespace {

/// Bullet limits the rotation of a body in a step to this, rad.
constexpr float most_turn = ANGULAR_MOTION_THRESHOLD;

Vec3 limited_turn(Vec3 angular_velocity, float dt) {
  const float speed = length(angular_velocity);
  return speed * dt > most_turn ? most_turn / (speed * dt) * angular_velocity : angular_velocity;
}

}  // namespace

/// The angular velocity of a free body after dt, as its axes turn. Euler's equation in the body's frame, by
/// the implicit midpoint rule, which conserves energy and momentum. Bullet's own integration damps the
/// tumbling of fast bodies. It also skips small bodies, whose moments of inertia have a product below its
/// bound for a division.
btVector3 tumbled(const btRigidBody& body, const btVector3& angular, float dt) {
  const btMatrix3x3& axes = body.getWorldTransform().getBasis();
  const btVector3 inertia = body.getLocalInertia(), inverse = body.getInvInertiaDiagLocal();
  const btMatrix3x3 over_inertia(inverse.x(), 0, 0, 0, inverse.y(), 0, 0, 0, inverse.z());
  const btVector3 before = angular * axes;
  const float speed = before.length(), turning = btMin(dt, most_turn / btMax(speed, FLT_MIN));
  btVector3 after = before;
  for (int i = 0; i < rigid_tuning::newton_steps; ++i) {
    const btVector3 w = 0.5f * (before + after), momentum = inertia * w;
    const btVector3 error = after - before + turning * inverse * w.cross(momentum);
    if (error.length() <= FLT_EPSILON * speed) break;
    btMatrix3x3 turn, spin;
    w.getSkewSymmetricMatrix(&turn[0], &turn[1], &turn[2]);
    momentum.getSkewSymmetricMatrix(&spin[0], &spin[1], &spin[2]);
    const btMatrix3x3 slope =
        btMatrix3x3::getIdentity() + over_inertia * (turn.scaled(inertia) - spin) * (0.5f * turning);
    after -= slope.solve33(error);
  }
  return axes * after;
}

namespace {

/// Velocities that are not those of Bullet's body, except between two calls of swap().
struct Velocity {
  btRigidBody* body;
  btVector3 linear, angular;

  void swap() {
    const btVector3 own_linear = body->getLinearVelocity(), own_angular = body->getAngularVelocity();
    body->setLinearVelocity(linear);
    body->setAngularVelocity(angular);
    linear = own_linear;
    angular = own_angular;
  }
};

/// A body that is followed through Bullet's steps without contacts. The axes of its inertia are those at the
/// start.
class Flight {
 public:
  Flight(btRigidBody& body, const RigidMemory& memory, float dt, int substeps)
      : now{&body, body.getLinearVelocity(), body.getAngularVelocity()},
        fraction_(1 / static_cast<float>(substeps)),
        h_(fraction_ * dt),
        gain_(h_ * (body.getGravity() + body.getInvMass() * in_mass_units(memory.force))),
        spin_(h_ * (body.getInvInertiaTensorWorld() * in_mass_units(memory.torque))),
        kept_(btPow(1 - body.getLinearDamping(), h_)),
        angular_kept_(btPow(1 - body.getAngularDamping(), h_)),
        mean_{from_bullet(body.getWorldTransform()), {0, 0, 0}, {0, 0, 0}} {}

  /// What one of Bullet's steps does to the velocities before forces act.
  void begin_step() {
    now.linear = kept_ * now.linear;
    now.angular = angular_kept_ * tumbled(*now.body, now.angular, h_);
  }
  /// Adds the forces of one of Bullet's steps.
  void push() {
    now.linear += gain_;
    now.angular += spin_;
  }
  /// Adds the velocities to their means.
  void note() {
    mean_.velocity += fraction_ * from_bullet(now.linear);
    mean_.angular_velocity += fraction_ * limited_turn(from_bullet(now.angular), h_);
  }
  const RigidMotion& mean() const { return mean_; }

  Velocity now;

 private:
  float fraction_, h_;  // of dt; s
  btVector3 gain_, spin_;
  float kept_, angular_kept_;
  RigidMotion mean_;
};

RigidMotion free_flight(btRigidBody& body, const RigidMemory& memory, float dt, int substeps) {
  Flight flight(body, memory, dt, substeps);
  for (int i = 0; i < substeps; ++i) {
    flight.begin_step();
    flight.push();
    flight.note();
  }
  return flight.mean();
}

}  // namespace

RigidMotion asleep(const btRigidBody& body, const RigidMemory& memory, float dt) {
  const btVector3 linear = body.getInvMass() * in_mass_units(memory.usual_force);
  const btVector3 angular = body.getInvInertiaTensorWorld() * in_mass_units(memory.usual_torque);
  const float yielding = yielding_of(memory);
  return {from_bullet(body.getWorldTransform()), -dt * yielding * from_bullet(linear),
          -dt * yielding * from_bullet(angular), normalized_or(memory.usual_force, {0, 0, 0}), yielding};
}

/// The bodies that joints hold, followed together. Bullet's solver adds their forces.
struct RigidWorld::Impl::JointedFlight {
  std::vector<Flight> flights;
  std::vector<uint32_t> numbers;  ///< of their bodies
  std::vector<Velocity> driven;   ///< kinematic bodies
  btAlignedObjectArray<btCollisionObject*> bodies;
  btAlignedObjectArray<btTypedConstraint*> joints;

  void add(RigidBodyRecord& body) {
    body.bullet->clearForces();
    body.bullet->applyGravity();
    body.bullet->applyCentralForce(in_mass_units(body.memory.force));
    body.bullet->applyTorque(in_mass_units(body.memory.torque));
    bodies.push_back(body.bullet.get());
  }
  void swap() {
    for (Flight& flight : flights) flight.now.swap();
    for (Velocity& velocity : driven) velocity.swap();
  }
};

RigidWorld::Impl::JointedFlight RigidWorld::Impl::jointed_flight(float dt,
                                                                 std::span<const RigidMotion> motions) const {
  JointedFlight all;
  std::vector<bool> is_jointed(bodies.slots.size());
  for (const auto& joint : joints.slots) {
    if (!joint) continue;
    const auto flies = [&](uint32_t n) {
      return bodies.has(n) && !bodies.slots[n]->kinematic && bodies.slots[n]->bullet->isActive();
    };
    if (!flies(joint->a) && !flies(joint->b)) continue;
    all.joints.push_back(joint->bullet.get());
    for (const uint32_t n : {joint->a, joint->b})
      if (bodies.has(n)) is_jointed[n] = true;
  }
  for (uint32_t n = 0; n < is_jointed.size(); ++n) {
    if (!is_jointed[n]) continue;
    RigidBodyRecord& body = *bodies.slots[n];
    all.add(body);
    if (body.kinematic) {
      all.driven.push_back(
          {body.bullet.get(), to_bullet(motions[n].velocity), to_bullet(motions[n].angular_velocity)});
    } else if (body.bullet->isActive()) {
      all.flights.emplace_back(*body.bullet, body.memory, dt, def.substeps);
      all.numbers.push_back(n);
    }
  }
  return all;
}

/// Predicts bodies that joints hold with what their joints and motors will do.
void RigidWorld::Impl::predict_jointed(float dt, std::span<RigidMotion> motions) {
  const InBullet bullet(reserve, size());
  JointedFlight all = jointed_flight(dt, motions);
  if (all.joints.size() == 0) return;
  btContactSolverInfo info = dynamics.getSolverInfo();
  info.m_timeStep = dt / static_cast<float>(def.substeps);
  info.m_splitImpulse = false;  // there are no contacts, and no body is to be moved
  limit_motors(info.m_timeStep);
  for (int i = 0; i < def.substeps; ++i) {
    for (Flight& flight : all.flights) flight.begin_step();
    all.swap();
    joint_solver.solveGroup(&all.bodies[0], all.bodies.size(), nullptr, 0, &all.joints[0], all.joints.size(),
                            info, nullptr, &dispatcher);
    all.swap();
    for (Flight& flight : all.flights) flight.note();
  }
  for (size_t k = 0; k < all.flights.size(); ++k) motions[all.numbers[k]] = all.flights[k].mean();
}

/// The motion of a kinematic body.
RigidMotion RigidWorld::Impl::driven_motion(const RigidBodyRecord& body, float dt) const {
  const Pose start = body.memory.pose * body.shape.frame;
  const Pose target = kinematic_pose(body, time + dt) * body.shape.frame;
  const KinematicVelocity v = velocity_to(start, target, dt);
  return {start, v.linear, v.angular};
}

void RigidWorld::predict(float dt, std::span<RigidMotion> out) const {
  assert(out.size() >= body_slots());
  std::ranges::fill(out, RigidMotion{{}, {0, 0, 0}, {0, 0, 0}});
  impl_->for_each_body([&](uint32_t n, const RigidBodyRecord& body) {
    if (dt == 0) {
      out[n].start = from_bullet(body.bullet->getWorldTransform());
    } else if (body.kinematic) {
      out[n] = impl_->driven_motion(body, dt);
    } else if (!body.bullet->isActive()) {
      out[n] = asleep(*body.bullet, body.memory, dt);
    } else if (impl_->def.on_device) {
      out[n] = impl_->flight_on_device(body, dt);
    } else {
      out[n] = free_flight(*body.bullet, body.memory, dt, impl_->def.substeps);
    }
  });
  if (dt > 0) impl_->predict_jointed(dt, out);
}

/// A device has no joints.
void RigidWorld::predict_among_solids(float dt, std::span<RigidMotion> out) const {
  std::ranges::fill(out, RigidMotion{{}, {0, 0, 0}, {0, 0, 0}});
  impl_->for_each_body([&](uint32_t n, const RigidBodyRecord& body) {
    out[n] = body.kinematic ? impl_->driven_motion(body, dt) : impl_->unpushed_motion(n, body, dt);
  });
}

}  // namespace meniscus::collision
