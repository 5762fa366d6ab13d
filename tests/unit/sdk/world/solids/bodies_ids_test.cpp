// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Bodies and joints come and go; their ids mean them alone.
#include <gtest/gtest.h>

#include "tests/unit/sdk/world/solids/body_worlds.h"

namespace meniscus::tests {
namespace {

class BodyIdTest : public OnDevice {
 protected:
  World world_{world_def(GetParam(), 0.05f)};

  template <class Call>
  void expect_unknown(const std::string& what, const Call& call) {
    expect_error(ErrorCode::not_found, what, call);
  }

  /// Every call that takes a body.
  void expect_unknown_body(BodyId id) {
    expect_unknown("body", [&] { world_.destroy_body(id); });
    expect_unknown("body", [&] { world_.body_state(id); });
    expect_unknown("body", [&] { world_.body_mass(id); });
    expect_unknown("body", [&] { world_.set_body_pose(id, {}); });
    expect_unknown("body", [&] { world_.set_body_velocity(id, {0, 0, 0}, {0, 0, 0}); });
    expect_unknown("body", [&] { world_.apply_force(id, {0, 0, 0}, {0, 0, 0}); });
    expect_unknown("body", [&] { world_.apply_torque(id, {0, 0, 0}); });
    expect_unknown("body", [&] { world_.apply_impulse(id, {0, 0, 0}, {0, 0, 0}); });
    expect_unknown("body", [&] { world_.move_body(id, {}, 1); });
    expect_unknown("body", [&] { world_.create_joint(joint(BallJoint{}, id)); });
  }

  void expect_unknown_joint(JointId id) {
    expect_unknown("joint", [&] { world_.destroy_joint(id); });
    expect_unknown("joint", [&] { world_.hinge_angle(id); });
  }
};

TEST_P(BodyIdTest, AnIdThatIsStaleMeansNothingThoughItsPlaceIsTakenAgain) {
  const BodyId gone = world_.create_body(body(BoxGeometry{}));
  const BodyId other = world_.create_body(body(SphereGeometry{}, {3, 0, 0}));
  world_.destroy_body(gone);
  expect_unknown_body(gone);
  const BodyId next = world_.create_body(body(BoxGeometry{}, {0, 7, 0}));
  EXPECT_EQ(next.index, gone.index);
  EXPECT_FALSE(next == gone);
  expect_unknown_body(gone);
  EXPECT_EQ(world_.body_state(next).pose.position.y, 7);
  EXPECT_EQ(world_.body_state(other).pose.position.x, 3);
  world_.step(0.01f);
}

TEST_P(BodyIdTest, IdsThatNoCreateCallGaveAreRefused) {
  world_.create_body(body(BoxGeometry{}));
  for (BodyId id : {BodyId{}, BodyId{0, 0}, BodyId{7, 1}}) expect_unknown_body(id);
  for (JointId id : {JointId{}, JointId{0, 0}}) expect_unknown_joint(id);
}

TEST_P(BodyIdTest, IdsOfAnotherWorldAreRefused) {
  World other(world_def(GetParam(), 0.05f));
  const BodyId foreign = other.create_body(body(BoxGeometry{}));
  const JointId foreign_joint = other.create_joint(joint(HingeJoint{}, foreign));
  const BodyId own = world_.create_body(body(BoxGeometry{}));
  world_.create_joint(joint(HingeJoint{}, own));
  expect_unknown_body(foreign);
  expect_unknown_joint(foreign_joint);
  expect_unknown("body", [&] { world_.create_joint(joint(BallJoint{}, own, foreign)); });
}

TEST_P(BodyIdTest, JointsGoWithEitherOfTheirBodies) {
  const BodyId a = world_.create_body(body(BoxGeometry{}, {-1, 0, 0}));
  const BodyId b = world_.create_body(body(BoxGeometry{}, {1, 0, 0}));
  const BodyId c = world_.create_body(body(BoxGeometry{}, {3, 0, 0}));
  const JointId to_world = world_.create_joint(joint(HingeJoint{}, a));
  const JointId a_to_b = world_.create_joint(joint(HingeJoint{}, a, b));
  const JointId b_to_c = world_.create_joint(joint(HingeJoint{}, b, c));
  world_.destroy_body(b);
  expect_unknown_joint(a_to_b);
  expect_unknown_joint(b_to_c);
  EXPECT_EQ(world_.hinge_angle(to_world), 0);
  world_.step(0.01f);
  // Their places are taken again.
  const JointId next = world_.create_joint(joint(HingeJoint{}, a, c));
  EXPECT_EQ(next.index, a_to_b.index);
  expect_unknown_joint(a_to_b);
  world_.destroy_joint(next);
  expect_unknown_joint(next);
  world_.destroy_body(a);
  expect_unknown_joint(to_world);
  world_.step(0.01f);
}

TEST_P(BodyIdTest, WithoutItsJointABodyFalls) {
  const BodyId held = world_.create_body(body(BoxGeometry{}));
  const JointId holds = world_.create_joint(joint(FixedJoint{}, held));
  run(world_, 20, 0.01f);
  EXPECT_NEAR(world_.body_state(held).pose.position.y, 0, 1e-3f);
  world_.destroy_joint(holds);
  run(world_, 20, 0.01f);
  EXPECT_NEAR(world_.body_state(held).velocity.y, -9.81f * 0.2f, 0.01f);
}

// The angle is of b about a: here of the world about the wheel.
TEST_P(BodyIdTest, AHingeTellsItsAngleAndOtherJointsHaveNone) {
  BodyDef wheel = body(CylinderGeometry{0.5f, 0.1f});
  wheel.angular_velocity = {0, 2, 0};
  const BodyId id = world_.create_body(wheel);
  const JointId hinge = world_.create_joint(joint(HingeJoint{}, id));
  run(world_, 50, 0.01f);
  EXPECT_NEAR(world_.hinge_angle(hinge), -1, 0.01);
  const JointId ball = world_.create_joint(joint(BallJoint{}, id));
  expect_error(ErrorCode::invalid_argument, "hinge_angle", [&] { world_.hinge_angle(ball); });
}

TEST_P(BodyIdTest, AWorldThatIsLeftEmptyIsAsNew) {
  World twin(world_def(GetParam(), 0.05f));
  for (int k = 0; k < 5; ++k) {
    const BodyId a = world_.create_body(body(SphereGeometry{}));
    const BodyId b = world_.create_body(body(HullGeometry{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}));
    world_.create_joint(joint(BallJoint{}, a, b));
    world_.destroy_body(a);
    world_.destroy_body(b);
  }
  for (World* world : {&world_, &twin}) {
    world->create_shape(open_tank({0.3f, 0.5f, 0.3f}));
    world->add_fluid(block(world->create_fluid({}), {-0.3f, 0, -0.3f}, {0.3f, 0.2f, 0.3f}));
    world->create_body(body(BoxGeometry{{0.1f, 0.1f, 0.1f}}, {0, 0.4f, 0}));
    run(*world, 10, 0.01f);
  }
  EXPECT_EQ(world_.state_hash(), twin.state_hash());
}

// What particles did to the body that had the place before is nothing to the next.
TEST_P(BodyIdTest, ABodyInATakenPlaceHasNoForceYet) {
  world_.create_shape(open_tank({0.3f, 0.5f, 0.3f}));
  world_.add_fluid(block(world_.create_fluid({}), {-0.3f, 0, -0.3f}, {0.3f, 0.3f, 0.3f}));
  const BodyId wet = world_.create_body(body(BoxGeometry{{0.1f, 0.1f, 0.1f}}, {0, 0.4f, 0}));
  world_.create_body(body(BoxGeometry{{0.1f, 0.1f, 0.1f}}, {0, 2, 0}));
  for (int k = 0; k < 50 && length(world_.body_state(wet).fluid_force) < 1; ++k) world_.step(0.01f);
  ASSERT_GT(length(world_.body_state(wet).fluid_force), 1);
  world_.destroy_body(wet);
  const BodyId dry = world_.create_body(body(BoxGeometry{{0.1f, 0.1f, 0.1f}}, {3, 0, 0}));
  EXPECT_EQ(world_.body_state(dry).fluid_force, (Vec3{0, 0, 0}));
  EXPECT_EQ(world_.body_state(dry).fluid_torque, (Vec3{0, 0, 0}));
}

MENISCUS_ON_EACH_DEVICE(BodyIdTest);

}  // namespace
}  // namespace meniscus::tests
