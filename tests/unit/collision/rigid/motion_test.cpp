// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The motion of bodies, and its prediction.
#include <gtest/gtest.h>

#include "tests/unit/collision/rigid/solvers.h"

namespace meniscus::collision {

namespace {

constexpr float dt = 0.004f;

float angle_between(Quat a, Quat b) {
  const Quat turn = b * conjugate(a);
  return 2 * std::atan2(length({turn.x, turn.y, turn.z}), std::fabs(turn.w));
}

/// Steps on and says by how much the prediction was off, m and rad.
std::pair<float, float> prediction_error(RigidWorld& world, uint32_t body, const RigidImpulse& impulse = {}) {
  std::vector<RigidMotion> motion(world.body_slots());
  world.predict(dt, motion);
  const Pose start = motion[body].start;
  std::vector<RigidImpulse> impulses(world.body_slots(), {{0, 0, 0}, {0, 0, 0}});
  impulses[body] = impulse;
  world.step(dt, impulses);
  const Pose end = world.pose(body) * world.mass(body).principal;
  const Pose predicted{start.position + dt * motion[body].velocity,
                       rotation_by(dt * motion[body].angular_velocity) * start.rotation};
  return {length(end.position - predicted.position), angle_between(end.rotation, predicted.rotation)};
}

RigidPart moved(RigidPart part, Vec3 position) {
  part.pose.position = position;
  return part;
}

}  // namespace

class RigidPrediction : public testing::TestWithParam<std::tuple<Solver, int>> {};

TEST_P(RigidPrediction, HoldsForFreeFlight) {
  const auto [solver, substeps] = GetParam();
  SolverWorld world(solver, {.substeps = substeps});
  RigidBodyDef def =
      body_def({box_part({0.2f, 0.1f, 0.05f}), moved(box_part({0.1f, 0.1f, 0.1f}), {0.3f, 0, 0.1f})},
               {{1, 2, 3}, about({0.6f, 0, 0.8f}, 1)});
  def.velocity = {1, 2, -3};
  def.angular_velocity = {3, -5, 2};
  def.linear_damping = 0.3f;
  def.angular_damping = 0.5f;
  const uint32_t body = world.add_body(def);
  for (int i = 0; i < 100; ++i) {
    world.apply_force(body, {30, 0, 0}, world.centre_of_mass(body));
    world.apply_torque(body, {0, 0.5f, 0});
    const auto [distance, angle] = prediction_error(world, body);
    ASSERT_LT(distance, 3e-6f) << i;  // a dozen roundings
    // Over several steps, or small steps, the axes turn with the body: second order in the step.
    ASSERT_LT(angle, substeps == 1 && solver == Solver::bullet ? 2e-6f : 2e-4f) << i;
    world.end_step();
  }
}

INSTANTIATE_TEST_SUITE_P(Substeps, RigidPrediction,
                         testing::Combine(testing::ValuesIn(solvers), testing::Values(1, 4)));

class RigidMotionTest : public OnSolver {};
MENISCUS_WITH_EACH_SOLVER(RigidMotionTest);

class RigidKinematicsTest : public OnSolver {};
MENISCUS_WITH_EACH_SOLVER(RigidKinematicsTest);

TEST_P(RigidMotionTest, ImpulsesComeOnTop) {
  SolverWorld world(GetParam());
  const uint32_t body = world.add_body(body_def(box_part({0.1f, 0.1f, 0.1f}), {0, 0, 0}));
  const RigidMass mass = world.mass(body);
  EXPECT_NEAR(mass.inverse_mass, 1 / 8.0f, 1e-6f);
  EXPECT_NEAR(mass.inverse_inertia.x, 1 / (8 * 0.04f / 6), 1e-3f);
  world.step(dt, std::vector<RigidImpulse>{{{0.8f, 0, 0}, {0, 0.01f, 0}}});
  EXPECT_NEAR(world.velocity(body).x, 0.1f, 1e-6f);
  EXPECT_NEAR(world.velocity(body).y, -9.81f * dt, 1e-6f);
  EXPECT_NEAR(world.angular_velocity(body).y, 0.01f * mass.inverse_inertia.y, 1e-5f);
  world.apply_impulse(body, {0, 0, 8}, {0.1f, world.centre_of_mass(body).y, 0});
  EXPECT_NEAR(world.velocity(body).z, 1, 1e-6f);
}

TEST_P(RigidMotionTest, DampingIsAShareASecond) {
  SolverWorld world(GetParam(), {.gravity = {0, 0, 0}});
  RigidBodyDef def = body_def(round_part(Kind::sphere, 0.1f), {0, 0, 0});
  def.velocity = {2, 0, 0};
  def.angular_velocity = {0, 4, 0};
  def.linear_damping = 0.4f;
  def.angular_damping = 0.75f;
  const uint32_t body = world.add_body(def);
  run(world, dt, 250);
  EXPECT_NEAR(world.velocity(body).x, 1.2f, 1e-3f);
  EXPECT_NEAR(world.angular_velocity(body).y, 1, 1e-3f);
}

struct Top {
  const char* name;
  Vec3 half, spin;  ///< m and rad/s
};

void PrintTo(const Top& top, std::ostream* out) {
  *out << top.name;
}

class RigidTop : public testing::TestWithParam<std::tuple<Solver, Top>> {};

// Bullet's own integration removes the tumbling part of the coin's motion within two seconds.
TEST_P(RigidTop, KeepsMomentumAndEnergy) {
  const auto& [solver, top] = GetParam();
  SolverWorld world(solver, {.gravity = {0, 0, 0}});
  RigidBodyDef def = body_def(box_part(top.half), {0, 0, 0});
  def.angular_velocity = top.spin;
  const uint32_t body = world.add_body(def);
  const Vec3 i = world.mass(body).inverse_inertia;
  const auto pose = [&] { return world.pose(body) * world.mass(body).principal; };
  const auto turning = [&] { return rotate(conjugate(pose().rotation), world.angular_velocity(body)); };
  const auto momentum = [&] {
    const Vec3 w = turning();
    return rotate(pose().rotation, {w.x / i.x, w.y / i.y, w.z / i.z});
  };
  const auto energy = [&] { return dot(world.angular_velocity(body), momentum()); };
  const Vec3 momentum_before = momentum();
  const float energy_before = energy();
  Vec3 least = turning(), most = least;
  for (int k = 0; k < 2400; ++k) {
    world.step(1 / 240.0f, {});
    least = min(least, turning());
    most = max(most, turning());
  }
  EXPECT_GT(max_component(most - least), 0.5f * length(top.spin));  // it tumbles
  EXPECT_NEAR(energy(), energy_before, 0.005f * energy_before);
  EXPECT_NEAR(length(momentum()), length(momentum_before), 0.005f * length(momentum_before));
  EXPECT_LT(length(momentum() - momentum_before), 0.05f * length(momentum_before));
}

std::string top_test_name(const testing::TestParamInfo<std::tuple<Solver, Top>>& info) {
  return std::string(std::get<1>(info.param).name) + "_" + testing::PrintToString(std::get<0>(info.param));
}

INSTANTIATE_TEST_SUITE_P(
    Tops, RigidTop,
    testing::Combine(testing::ValuesIn(solvers),
                     testing::Values(Top{"Plate", {0.2f, 0.1f, 0.02f}, {0.1f, 3, 0.1f}},
                                     Top{"SmallPlate", {0.01f, 0.005f, 0.001f}, {0.1f, 3, 0.1f}},
                                     Top{"Coin", {0.001f, 0.01f, 0.01f}, {30, 10, 0}},
                                     Top{"Brick", {0.1f, 0.05f, 0.03f}, {10, 10, 10}})),
    top_test_name);

TEST_P(RigidMotionTest, PosesAreOfTheGeometry) {
  SolverWorld world(GetParam());
  const Pose pose{{1, 2, 3}, about({0.6f, 0, 0.8f}, 1)};
  const RigidBodyDef def = body_def({moved(box_part({0.2f, 0.1f, 0.1f}), {1, 0, 0})}, pose);
  const uint32_t body = world.add_body(def);
  EXPECT_LT(length(world.pose(body).position - pose.position), 1e-6f);
  EXPECT_LT(angle_between(world.pose(body).rotation, pose.rotation), 1e-6f);
  EXPECT_LT(length(world.centre_of_mass(body) - to_world(pose, {1, 0, 0})), 1e-6f);
  world.set_pose(body, {{0, 5, 0}, no_turn});
  EXPECT_LT(length(world.centre_of_mass(body) - Vec3{1, 5, 0}), 1e-6f);
}

TEST_P(RigidKinematicsTest, KeyframesAreMetExactly) {
  SolverWorld world(GetParam(), {.substeps = 3});
  RigidBodyDef def = kinematic_def({moved(box_part({0.5f, 0.1f, 0.1f}), {0.5f, 0, 0})}, {});
  const Pose second{{1, 2, 0}, about({0, 1, 0}, 2)}, third{{0, 0, 4}, about({1, 0, 0}, -1)};
  def.keyframes = {{0.1f, {{1, 0, 0}, no_turn}}, {0.5f, second}, {0.9f, third}};
  const uint32_t body = world.add_body(def);
  EXPECT_EQ(world.pose(body).position.x, 1);
  for (int i = 0; i < 300; ++i) {
    const auto [distance, angle] = prediction_error(world, body);
    ASSERT_LT(distance, 2e-6f) << i;
    ASSERT_LT(angle, 2e-6f) << i;
    if (i == 74) {  // half-way, at 0.3 s
      EXPECT_LT(length(world.pose(body).position - Vec3{1, 1, 0}), 1e-4f);
      EXPECT_LT(angle_between(world.pose(body).rotation, about({0, 1, 0}, 1)), 1e-4f);
      EXPECT_NEAR(world.angular_velocity(body).y, 2 / 0.4f, 1e-3f);
    }
    if (i == 124) {
      EXPECT_LT(length(world.pose(body).position - second.position), 1e-4f);
    }
  }
  EXPECT_EQ(world.pose(body).position.z, 4);
  EXPECT_EQ(length(world.velocity(body)), 0);
}

TEST_P(RigidKinematicsTest, LoopsGoOn) {
  SolverWorld world(GetParam());
  RigidBodyDef def = kinematic_def({box_part({0.1f, 0.1f, 0.1f})}, {});
  def.keyframes = {{0, {{0, 0, 0}, no_turn}}, {0.5f, {{1, 0, 0}, no_turn}}, {1, {{0, 0, 0}, no_turn}}};
  def.loop = true;
  const uint32_t body = world.add_body(def);
  run(world, dt, 1125);  // 4.5 s
  EXPECT_NEAR(world.pose(body).position.x, 1, 1e-3f);
  run(world, dt, 125);
  EXPECT_NEAR(world.pose(body).position.x, 0, 1e-3f);
}

TEST_P(RigidKinematicsTest, AMoveEndsAtItsTarget) {
  SolverWorld world(GetParam());
  const uint32_t body = world.add_body(kinematic_def({box_part({0.1f, 0.1f, 0.1f})}, {}));
  const Pose target{{1, -1, 2}, about({0, 0, 1}, 3)};
  world.move(body, target, 0.2f);
  run(world, dt, 25);
  EXPECT_LT(length(world.pose(body).position - 0.5f * target.position), 1e-3f);
  EXPECT_NEAR(world.velocity(body).x, 5, 1e-2f);
  run(world, dt, 26);
  EXPECT_EQ(world.pose(body).position.z, 2);
  EXPECT_EQ(length(world.velocity(body)), 0);
  world.set_pose(body, {});
  EXPECT_EQ(length(world.velocity(body)), 0);
  run(world, dt, 1);
  EXPECT_EQ(world.pose(body).position.x, 0);
}

TEST_P(RigidKinematicsTest, CarriesWhatLiesOnItAndPushes) {
  SolverWorld world(GetParam());
  RigidBodyDef belt = kinematic_def({box_part({5, 0.1f, 1})}, {});
  belt.solid.friction = 1;
  const uint32_t carrier = world.add_body(belt);
  RigidBodyDef def = body_def(box_part({0.1f, 0.1f, 0.1f}), {0, 0.2f, 0});
  def.solid.friction = 1;
  const uint32_t box = world.add_body(def);
  run(world, dt, 50);
  world.move(carrier, {{1, 0.3f, 0}, no_turn}, 1);
  run(world, dt, 200);
  EXPECT_NEAR(world.velocity(box).x, 1, 0.02f);
  EXPECT_NEAR(world.velocity(box).y, 0.3f, 0.02f);
  EXPECT_NEAR(world.pose(box).position.y, world.pose(carrier).position.y + 0.2f, 0.002f);
}

TEST(RigidWorldNumbers, TheLowestIsUsedAgain) {
  RigidWorld world({});
  const RigidBodyDef def = body_def(box_part({0.1f, 0.1f, 0.1f}), {0, 0, 0});
  for (uint32_t i = 0; i < 4; ++i) EXPECT_EQ(world.add_body(def), i);
  world.remove(RigidRef{true, 2});
  world.remove(RigidRef{true, 1});
  EXPECT_EQ(world.body_slots(), 4u);
  EXPECT_EQ(world.body_count(), 2u);
  EXPECT_EQ(world.mass(1).inverse_mass, 0);
  std::vector<RigidMotion> motion(4);
  world.predict(dt, motion);
  EXPECT_EQ(length(motion[1].velocity), 0);
  EXPECT_EQ(world.add_body(def), 1u);
  EXPECT_EQ(world.add_body(def), 2u);
  EXPECT_EQ(world.add_body(def), 4u);
  world.remove(RigidRef{true, 4});
  EXPECT_EQ(world.body_slots(), 4u);
  const RigidSolid solid = fixed_solid(plane_part());
  EXPECT_EQ(world.add_fixed(solid), 0u);
  EXPECT_EQ(world.add_fixed(solid), 1u);
  world.remove(RigidRef{false, 0});
  EXPECT_EQ(world.add_fixed(solid), 0u);
}

}  // namespace meniscus::collision
