// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Bodies that follow a given motion, whatever obstacles they meet.
#include <gtest/gtest.h>

#include "tests/rigid_solvers.h"
#include "tests/unit/sdk/world/solids/body_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float dt = 0.01f;

class KinematicBodyTest : public WithSolver {
 protected:
  World world_{world_def(GetParam(), 0.05f)};

  /// Waits at x = 1, goes to x = 3 and a quarter turn from 0.1 s to 0.3 s, then up for 0.2 s.
  static std::vector<Keyframe> path() {
    return {{0.1f, {{1, 0, 0}}}, {0.3f, {{3, 0, 0}, about_z(90)}}, {0.5f, {{3, 1, 0}, about_z(90)}}};
  }
  BodyId add_guided(bool loop) {
    BodyDef def = kinematic(BoxGeometry{{0.1f, 0.1f, 0.1f}});
    def.keyframes = path();
    def.loop = loop;
    return world_.create_body(def);
  }
  /// Degrees about z.
  float turn(BodyId id) const {
    const Vec3 x = rotate(world_.body_state(id).pose.rotation, {1, 0, 0});
    return std::atan2(x.y, x.x) * 180 / pi;
  }
  Vec3 place(BodyId id) const { return world_.body_state(id).pose.position; }
};

TEST_P(KinematicBodyTest, NothingMovesOneThatIsToldNothing) {
  const BodyId id = world_.create_body(kinematic(BoxGeometry{}, {1, 2, 3}));
  world_.create_body(body(BoxGeometry{}, {1, 3.2f, 3}));  // falls on it
  run(world_, 50, dt);
  EXPECT_EQ(place(id), (Vec3{1, 2, 3}));
  EXPECT_EQ(world_.body_state(id).velocity, (Vec3{0, 0, 0}));
}

TEST_P(KinematicBodyTest, KeyframesAreMetAtTheirTimes) {
  const BodyId id = add_guided(false);
  run(world_, 10, dt);
  expect_near(place(id), {1, 0, 0}, 1e-5f);
  run(world_, 10, dt);  // 0.2 s
  expect_near(place(id), {2, 0, 0}, 1e-4f);
  EXPECT_NEAR(turn(id), 45, 0.01f);
  expect_near(world_.body_state(id).velocity, {10, 0, 0}, 0.01f);
  EXPECT_NEAR(world_.body_state(id).angular_velocity.z, pi / 2 / 0.2f, 0.01f);
  run(world_, 20, dt);  // 0.4 s
  expect_near(place(id), {3, 0.5f, 0}, 1e-4f);
  EXPECT_NEAR(turn(id), 90, 0.01f);
  run(world_, 60, dt);  // long after the last
  expect_near(place(id), {3, 1, 0}, 1e-5f);
  EXPECT_EQ(world_.body_state(id).velocity, (Vec3{0, 0, 0}));
}

TEST_P(KinematicBodyTest, ALoopStartsAgainAtTheFirst) {
  const BodyId id = add_guided(true);
  run(world_, 60, dt);  // 0.6 s, that is 0.1 s into the second round, which has 0.4 s
  expect_near(place(id), {2, 0, 0}, 1e-3f);
  run(world_, 80, dt);  // two rounds on
  expect_near(place(id), {2, 0, 0}, 1e-3f);
  EXPECT_NEAR(turn(id), 45, 0.1f);
}

TEST_P(KinematicBodyTest, KeyframesCountInTheWorldsTime) {
  run(world_, 20, dt);
  const BodyId id = add_guided(false);
  run(world_, 10, dt);  // 0.3 s of the world
  expect_near(place(id), {3, 0, 0}, 1e-4f);
}

TEST_P(KinematicBodyTest, MoveBodyTakesTheTimeItIsGivenAndThePlaceOfKeyframes) {
  const BodyId id = add_guided(true);
  run(world_, 10, dt);
  world_.move_body(id, {{1, -2, 0}, about_z(-60)}, 0.2f);
  run(world_, 10, dt);
  expect_near(place(id), {1, -1, 0}, 1e-4f);
  EXPECT_NEAR(turn(id), -30, 0.01f);
  expect_near(world_.body_state(id).velocity, {0, -10, 0}, 0.01f);
  run(world_, 40, dt);
  expect_near(place(id), {1, -2, 0}, 1e-5f);
  EXPECT_NEAR(turn(id), -60, 0.01f);
}

TEST_P(KinematicBodyTest, APoseThatIsSetEndsWhatItWasDoing) {
  const BodyId id = add_guided(true);
  run(world_, 20, dt);
  world_.set_body_pose(id, {{0, 9, 0}});
  run(world_, 10, dt);
  EXPECT_EQ(place(id), (Vec3{0, 9, 0}));
}

// The load slips by v²/2μg = 3 mm when it starts, and as far in the other direction when it stops.
TEST_P(KinematicBodyTest, ItCarriesWhatLiesOnIt) {
  const BodyId tray = world_.create_body(kinematic(BoxGeometry{{0.5f, 0.05f, 0.5f}}));
  const BodyId load = world_.create_body(body(BoxGeometry{{0.1f, 0.1f, 0.1f}}, {0, 0.15f, 0}));
  run(world_, 20, dt);
  world_.move_body(tray, {{0.3f, 0, 0}}, 1.8f);
  run(world_, 90, dt);
  EXPECT_NEAR(world_.body_state(load).velocity.x, 0.3f / 1.8f, 0.005f);
  run(world_, 110, dt);
  expect_near(place(load), {0.3f, 0.15f, 0}, 0.004f);
}

TEST_P(KinematicBodyTest, ItPushesParticlesAndFeelsTheirForce) {
  const FluidId water = world_.create_fluid({});
  world_.create_shape(open_tank({0.4f, 0.5f, 0.2f}));
  world_.add_fluid(block(water, {-0.4f, 0, -0.2f}, {0.4f, 0.3f, 0.2f}));
  const BodyId paddle = world_.create_body(kinematic(BoxGeometry{{0.03f, 0.3f, 0.2f}}, {-0.45f, 0.3f, 0}));
  world_.move_body(paddle, {{0, 0.3f, 0}}, 0.4f);
  run(world_, 30, dt);
  EXPECT_LT(world_.body_state(paddle).fluid_force.x, -1);  // it is pushed back, and goes on
  run(world_, 20, dt);
  EXPECT_NEAR(place(paddle).x, 0, 1e-5f);
  EXPECT_EQ(world_.diagnostics().outside, 0u);
  size_t before_it = 0;
  for (Vec3 p : world_.positions()) before_it += p.x > 0;
  EXPECT_GT(before_it, world_.particle_count() * 9 / 10);
}

// A cup is carried sideways, with its water.
TEST_P(KinematicBodyTest, AContainerCarriesWater) {
  const ContainerGeometry cup{{0.15f, 0.3f, 0.15f}, {{Face::y_high, {}}}};
  const BodyId id = world_.create_body(kinematic(cup, {0, 0.3f, 0}));
  const FluidVolumeDef fill = block(world_.create_fluid({}), {-0.15f, 0, -0.15f}, {0.15f, 0.2f, 0.15f});
  EXPECT_EQ(world_.add_fluid(fill), 6u * 4u * 6u);
  run(world_, 20, dt);
  world_.move_body(id, {{1, 0.8f, 0}}, 2);
  run(world_, 250, dt);
  EXPECT_EQ(world_.diagnostics().outside, 0u);
  EXPECT_NEAR(mean_height(world_), 0.5f + 0.1f, 0.02f);
  for (Vec3 p : world_.positions()) EXPECT_NEAR(p.x, 1, 0.15f);
}

TEST_P(KinematicBodyTest, ATurnedContainerPoursItsWaterOut) {
  const ContainerGeometry cup{{0.15f, 0.15f, 0.15f}, {{Face::y_high, {}}}};
  const BodyId id = world_.create_body(kinematic(cup, {0, 0.15f, 0}));
  world_.add_fluid(block(world_.create_fluid({}), {-0.15f, 0, -0.15f}, {0.15f, 0.2f, 0.15f}));
  world_.move_body(id, {{0, 0.15f, 0}, about_z(150)}, 1);
  run(world_, 200, dt);
  for (Vec3 p : world_.positions()) EXPECT_LT(p.y, -0.5f);
}

MENISCUS_WITH_EACH_RIGID_SOLVER(KinematicBodyTest);

}  // namespace
}  // namespace meniscus::tests
