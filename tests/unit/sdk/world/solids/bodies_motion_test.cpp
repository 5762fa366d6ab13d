// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Forces, impulses, velocities and poses that the user sets; damping and sleep.
#include <gtest/gtest.h>

#include "tests/rigid_solvers.h"
#include "tests/unit/sdk/world/solids/body_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float dt = 0.01f;  // four substeps

class BodyMotionTest : public WithSolver {
 protected:
  World world_{weightless(GetParam())};

  /// 8 kg, a cube of 0.2 m.
  BodyId add_cube(Vec3 position = {0, 0, 0}) {
    BodyDef def = body(BoxGeometry{{0.1f, 0.1f, 0.1f}}, position);
    def.density = 1000;
    return world_.create_body(def);
  }
  static constexpr float cube_inertia = 8 * 0.04f / 6;  // of 8 kg
};

TEST_P(BodyMotionTest, ABodyFallsAsFarAsGalileoSays) {
  World world(world_def(GetParam(), 0.05f));
  const BodyId id = world.create_body(body(SphereGeometry{}));
  run(world, 50, dt);
  // The device takes five steps in a substep.
  const float t = 0.5f, h = dt / (GetParam().solver == RigidSolver::device ? 20 : 4);
  EXPECT_NEAR(world.body_state(id).velocity.y, -9.81f * t, 1e-4f);
  EXPECT_NEAR(world.body_state(id).pose.position.y, -9.81f / 2 * t * (t + h), 1e-4f);
}

TEST_P(BodyMotionTest, AForceActsForOneStepAlone) {
  const BodyId id = add_cube();
  world_.apply_force(id, {16, 0, 0}, {0, 0, 0});
  world_.apply_force(id, {0, 8, 0}, {0, 0, 0});  // they add up
  world_.step(dt);
  expect_near(world_.body_state(id).velocity, {2 * dt, dt, 0}, 1e-6f);
  expect_near(world_.body_state(id).angular_velocity, {0, 0, 0}, 1e-6f);
  world_.step(dt);
  expect_near(world_.body_state(id).velocity, {2 * dt, dt, 0}, 1e-6f);
}

TEST_P(BodyMotionTest, AForceOffTheCentreTurns) {
  const BodyId id = add_cube({5, 0, 0});
  world_.apply_force(id, {0, 16, 0}, {5.1f, 0, 0});
  world_.step(dt);
  expect_near(world_.body_state(id).velocity, {0, 2 * dt, 0}, 1e-6f);
  expect_near(world_.body_state(id).angular_velocity, {0, 0, 1.6f * dt / cube_inertia}, 1e-4f);
}

TEST_P(BodyMotionTest, ATorqueTurnsAndDoesNotMove) {
  const BodyId id = add_cube();
  world_.apply_torque(id, {0, 0.5f, 0});
  run(world_, 2, dt);
  expect_near(world_.body_state(id).angular_velocity, {0, 0.5f * dt / cube_inertia, 0}, 1e-5f);
  expect_near(world_.body_state(id).velocity, {0, 0, 0}, 1e-7f);
}

TEST_P(BodyMotionTest, AnImpulseActsAtOnce) {
  const BodyId id = add_cube();
  world_.apply_impulse(id, {4, 0, 0}, {0, 0.1f, 0});
  expect_near(world_.body_state(id).velocity, {0.5f, 0, 0}, 1e-6f);
  expect_near(world_.body_state(id).angular_velocity, {0, 0, -0.4f / cube_inertia}, 1e-4f);
  world_.step(dt);
  expect_near(world_.body_state(id).velocity, {0.5f, 0, 0}, 1e-6f);
}

TEST_P(BodyMotionTest, AForceInAStepThatFailsIsStillThereAfterwards) {
  const BodyId id = add_cube();
  const FluidId water = world_.create_fluid({});
  world_.add_particles(water, std::vector<Vec3>{{9, 9, 9}}, std::vector<Vec3>{{3e38f, 0, 0}});
  world_.apply_force(id, {16, 0, 0}, {0, 0, 0});
  const uint64_t hash = world_.state_hash();
  expect_error(ErrorCode::non_finite, "non-finite", [&] { world_.step(1000); });
  EXPECT_EQ(world_.state_hash(), hash);
  world_.remove_particles(world_.ids());
  world_.step(dt);
  expect_near(world_.body_state(id).velocity, {2 * dt, 0, 0}, 1e-6f);
}

TEST_P(BodyMotionTest, VelocitiesAreThoseOfTheCentreOfMass) {
  CompoundGeometry lopsided;
  lopsided.parts.push_back({BoxGeometry{{0.1f, 0.1f, 0.1f}}, {{1, 0, 0}}});
  BodyDef def = body(lopsided);
  def.velocity = {1, 2, 3};
  def.angular_velocity = {0, 0, 2};
  const BodyId id = world_.create_body(def);
  run(world_, 10, dt);
  expect_near(world_.body_state(id).velocity, {1, 2, 3}, 1e-5f);
  expect_near(world_.body_state(id).centre_of_mass, {1.1f, 0.2f, 0.3f}, 1e-5f);
  world_.set_body_velocity(id, {0, 0, 0}, {0, 0, 1});
  expect_near(world_.body_state(id).angular_velocity, {0, 0, 1}, 0);
  run(world_, 10, dt);
  expect_near(world_.body_state(id).centre_of_mass, {1.1f, 0.2f, 0.3f}, 1e-5f);
  // The frame's origin went around the centre, by 0.2 and 0.1 rad.
  expect_near(world_.body_state(id).pose.position, {1.1f - std::cos(0.3f), 0.2f - std::sin(0.3f), 0.3f},
              1e-4f);
}

TEST_P(BodyMotionTest, APoseThatIsSetIsThereAtOnceAndKeepsTheVelocity) {
  const BodyId id = add_cube();
  world_.set_body_velocity(id, {1, 0, 0}, {0, 0, 0});
  const uint64_t hash = world_.state_hash();
  world_.set_body_pose(id, {{3, 4, 5}, about_z(90)});
  EXPECT_NE(world_.state_hash(), hash);
  const BodyState state = world_.body_state(id);
  expect_near(state.pose.position, {3, 4, 5}, 1e-6f);
  expect_near(rotate(state.pose.rotation, {1, 0, 0}), {0, 1, 0}, 1e-5f);
  world_.step(dt);
  expect_near(world_.body_state(id).pose.position, {3 + dt, 4, 5}, 1e-5f);
}

TEST_P(BodyMotionTest, DampingTakesItsShareInASecond) {
  BodyDef def = body(SphereGeometry{});
  def.linear_damping = 0.3f;
  def.angular_damping = 0.6f;
  def.velocity = {2, 0, 0};
  def.angular_velocity = {0, 3, 0};
  const BodyId id = world_.create_body(def);
  run(world_, 100, dt);
  EXPECT_NEAR(world_.body_state(id).velocity.x, 2 * 0.7f, 1e-3f);
  EXPECT_NEAR(world_.body_state(id).angular_velocity.y, 3 * 0.4f, 1e-3f);
}

TEST_P(BodyMotionTest, ABodyAtRestFallsAsleepUnlessItMayNot) {
  World world(world_def(GetParam(), 0.05f));
  world.create_shape(shape(PlaneGeometry{}));
  BodyDef def = body(BoxGeometry{{0.1f, 0.1f, 0.1f}}, {0, 0.1f, 0});
  const BodyId sleeper = world.create_body(def);
  def.pose.position.x = 1;
  def.can_sleep = false;
  const BodyId watcher = world.create_body(def);
  run(world, 300, dt);
  EXPECT_FALSE(world.body_state(sleeper).awake);
  EXPECT_TRUE(world.body_state(watcher).awake);
  world.apply_impulse(sleeper, {0.1f, 0, 0}, {0, 0.1f, 0});
  EXPECT_TRUE(world.body_state(sleeper).awake);
}

TEST_P(BodyMotionTest, WithoutParticlesTheDeviceMakesNoDifference) {
  if (GetParam().solver == RigidSolver::device) GTEST_SKIP() << "its kernels run on the device";
  World twin(weightless(SolverCase{pbd::DeviceKind::cpu, GetParam().solver}));
  for (World* world : {&world_, &twin}) {
    BodyDef def = body(BoxGeometry{{0.1f, 0.2f, 0.3f}});
    def.angular_velocity = {1, 2, 3};
    world->create_body(def);
    run(*world, 20, dt);
  }
  EXPECT_EQ(world_.state_hash(), twin.state_hash());
}

MENISCUS_WITH_EACH_RIGID_SOLVER(BodyMotionTest);

}  // namespace
}  // namespace meniscus::tests
