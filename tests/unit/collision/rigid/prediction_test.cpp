// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The prediction of bodies that joints hold. Without contacts it is what the step then does.
#include <gtest/gtest.h>

#include "tests/unit/collision/rigid/scene.h"

namespace meniscus::collision {

namespace {

constexpr float dt = 0.004f;

/// A kinematic body that turns about y, a box beside it, and one that hangs from the world, at 1 rad/s.
struct Mechanism {
  RigidWorld world;
  uint32_t driver, arm, bob;

  explicit Mechanism(int substeps, const JointKind& held = BallJoint{})
      : world({.gravity = {1, -9.81f, 0}, .substeps = substeps}),
        driver(world.add_body(kinematic_def({box_part({0.1f, 0.1f, 0.1f})}, {}))),
        arm(world.add_body(body_def(box_part({0.1f, 0.1f, 0.1f}), {0.3f, 0, 0}))),
        bob(world.add_body(body_def(box_part({0.1f, 0.2f, 0.1f}), {2, 0.1f, 0}))) {
    world.move(driver, {{0, 0.01f, 0}, about({0, 1, 0}, 0.5f)}, 0.5f);
    join(driver, arm, JointKind{FixedJoint{}}, {});
    join(bob, pbd::no_index, held, {{2, 0.5f, 0}, about({0, 0, 1}, 0.4f)});
  }
  void join(uint32_t a, uint32_t b, const JointKind& kind, const Pose& frame) {
    RigidJointDef def;
    def.a = a;
    def.b = b;
    def.kind = kind;
    def.frame = frame;
    world.add_joint(def);
  }
  std::vector<RigidMotion> predict() const {
    std::vector<RigidMotion> motions(world.body_slots());
    world.predict(dt, motions);
    return motions;
  }
};

std::vector<JointKind> kinds() {
  return {BallJoint{}, FixedJoint{}, HingeJoint{.motor_speed = 2, .motor_torque = 3},
          SliderJoint{.motor_speed = 1, .motor_force = 50},
          SpringJoint{.stiffness = {2000, 2000, 2000}, .damping = {5, 5, 5}}};
}

}  // namespace

TEST(RigidPrediction, IsWhatJointsAndMotorsThenDo) {
  for (const JointKind& kind : kinds()) {
    Mechanism m(1, kind);
    run(m.world, dt, 20);
    for (int k = 0; k < 20; ++k) {
      const std::vector<RigidMotion> predicted = m.predict();
      m.world.step(dt, {});
      for (const uint32_t body : {m.driver, m.arm, m.bob}) {
        const RigidMotion& motion = predicted[body];
        std::vector<RigidMotion> now(m.world.body_slots());
        m.world.predict(0, now);
        const Vec3 moved = now[body].start.position - motion.start.position;
        EXPECT_LT(length(moved - dt * motion.velocity), 2e-6f) << "joint " << kind.index();
        const Quat turned = rotation_by(dt * motion.angular_velocity) * motion.start.rotation;
        const Quat off = turned * conjugate(now[body].start.rotation);
        EXPECT_LT(length(Vec3{off.x, off.y, off.z}), 2e-6f) << "joint " << kind.index();
      }
    }
  }
}

// With several steps of Bullet the joints are taken where they were at the start.
TEST(RigidPrediction, IsNearlyThatOverSeveralSteps) {
  for (const JointKind& kind : kinds()) {
    Mechanism m(4, kind);
    run(m.world, dt, 20);
    const Vec3 before = m.world.pose(m.bob).position;
    const Vec3 predicted = before + dt * m.predict()[m.bob].velocity;
    m.world.step(dt, {});
    EXPECT_LT(length(m.world.pose(m.bob).position - predicted), 2e-5f) << "joint " << kind.index();
  }
}

TEST(RigidPrediction, LeavesNoTrace) {
  for (const JointKind& kind : kinds()) {
    Mechanism plain(2, kind), predicted(2, kind);
    for (int k = 0; k < 30; ++k) {
      predicted.predict();
      plain.world.step(dt, {});
      predicted.world.step(dt, {});
    }
    EXPECT_EQ(hash_of(plain.world), hash_of(predicted.world)) << "joint " << kind.index();
  }
}

}  // namespace meniscus::collision
