// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Force fields against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/expect_error.h"
#include "tests/unit/sdk/world/extension/force_worlds.h"

namespace meniscus::tests {
namespace {

class ForceFieldsTest : public OnDevice {};

constexpr float dt = 0.01f;
constexpr float pi = std::numbers::pi_v<float>;

TEST_P(ForceFieldsTest, AUniformFieldIsLikeGravity) {
  OneOfEach all(weightless(GetParam()));
  all.world.create_force_field(field(UniformForce{{1, -9.81f, 2}}));
  run(all.world, 50, dt);
  for (const Vec3 v : all.velocities()) expect_near(v, {0.5f, -4.905f, 1}, 2e-4f);
  // Symplectic Euler: x = g h² n (n + 1)/2.
  constexpr float h = dt / 4, fallen = 0.5f * h * h * 200 * 201;
  expect_near(all.world.positions()[0], fallen * Vec3{1, -9.81f, 2}, 1e-4f, "the particle");
  expect_near(all.world.body_state(all.body).pose.position, Vec3{4, 0, 0} + fallen * Vec3{1, -9.81f, 2},
              1e-4f, "the body");
  expect_near(all.world.body_state(all.body).angular_velocity, {0, 0, 0}, 1e-6f, "the body's spin");
}

TEST_P(ForceFieldsTest, AFieldInItsFrameTurnsWithThat) {
  OneOfEach all(weightless(GetParam()));
  ForceFieldDef turned = field(UniformForce{{1, 0, 0}});
  turned.pose.rotation = about_z(90);
  all.world.create_force_field(turned);
  run(all.world, 10, dt);
  for (const Vec3 v : all.velocities()) expect_near(v, {0, 0.1f, 0}, 2e-4f);
}

TEST_P(ForceFieldsTest, LinearDragDecaysExponentially) {
  WorldDef def = weightless(GetParam(), 3);
  OneOfEach all(def, {3, -1, 2});
  const Vec3 u{1, 0, 0};
  all.world.create_force_field(field(DragForce{u, 2.5f}));
  all.world.set_body_velocity(all.body, {3, -1, 2}, {0, 0, 4});
  run(all.world, 40, dt);
  const float left = std::exp(-2.5f * 0.4f);
  const std::vector<Vec3> v = all.velocities();
  for (int k = 0; k < 3; ++k) expect_near(v[size_t(k)], u + left * (Vec3{3, -1, 2} - u), 1e-5f);
  for (int k = 3; k < 5; ++k) expect_near(v[size_t(k)], (1 - left) * u, 1e-4f);
  expect_near(all.world.body_state(all.body).angular_velocity, {0, 0, 4 * left}, 1e-4f, "spin");
}

TEST_P(ForceFieldsTest, QuadraticDragDecaysHyperbolically) {
  OneOfEach all(weightless(GetParam()), {4, 0, 0});
  all.world.create_force_field(field(DragForce{{0, 0, 0}, 0, 0.5f}));
  run(all.world, 50, dt);
  for (int k = 0; k < 2; ++k)
    expect_near(all.velocities()[size_t(k)], {4 / (1 + 0.5f * 4 * 0.5f), 0, 0}, 2e-5f);
}

TEST_P(ForceFieldsTest, DragOfAnyStrengthIsStable) {
  OneOfEach all(weightless(GetParam(), 1), {4, 0, 0});
  all.world.create_force_field(field(DragForce{{0, 1, 0}, 1e6f, 1e6f}));
  run(all.world, 3, 0.1f);
  for (const Vec3 v : all.velocities()) expect_near(v, {0, 1, 0}, 1e-3f);
}

TEST_P(ForceFieldsTest, APointAttractsOnAnOrbitOfKepler) {
  World world(weightless(GetParam(), 1));
  const FluidId water = world.create_fluid({});
  // Of the ellipse with half axis a = 2/3 about the origin of the field, with GM = 1.
  world.add_particles(water, std::vector<Vec3>{{6, 1, 0}}, std::vector<Vec3>{{0, 0, std::sqrt(0.5f)}});
  ForceFieldDef sun = field(RadialForce{-1, 1, 2, 1e-4f});
  sun.pose.position = {5, 1, 0};
  world.create_force_field(sun);
  const float a = 1 / (2 - 0.5f), period = 2 * pi * std::sqrt(a * a * a);
  constexpr int steps = 4000;
  run(world, steps / 2, period / steps);
  expect_near(world.positions()[0], {5 - (2 * a - 1), 1, 0}, 5e-3f, "the near end");
  run(world, steps / 2, period / steps);
  expect_near(world.positions()[0], {6, 1, 0}, 5e-3f, "the far end");
}

TEST_P(ForceFieldsTest, ASpringOscillates) {
  World world(weightless(GetParam(), 1));
  const BodyId body = world.create_body(brick({4, 0, 0}));
  world.create_force_field(field(RadialForce{-4 * pi * pi, 1, -1, 1e-3f}));
  run(world, 500, 0.001f);
  expect_near(world.body_state(body).pose.position, {-4, 0, 0}, 2e-3f, "after half a period");
  expect_near(world.body_state(body).angular_velocity, {0, 0, 0}, 1e-4f, "spin");
}

TEST_P(ForceFieldsTest, AVortexTurnsRigidly) {
  World world(weightless(GetParam(), 1));
  const FluidId water = world.create_fluid({});
  constexpr float omega = 3;
  std::vector<Vec3> at, flow;
  for (float r : {0.3f, 1.0f, 2.0f}) {
    at.push_back({r, 0, 0});
    flow.push_back({0, 0, -omega * r});
  }
  world.add_particles(water, at, flow);
  world.create_force_field(field(VortexForce{omega, 2}));
  constexpr int steps = 1000;
  run(world, steps, 2 * pi / omega / steps);
  for (size_t k = 0; k < at.size(); ++k) {
    expect_near(world.positions()[k], at[k], 0.02f * at[k].x, "after a turn");
    EXPECT_NEAR(length(world.positions()[k]), at[k].x, 0.005f * at[k].x);
  }
}

TEST_P(ForceFieldsTest, AVortexSpinsABody) {
  World world(weightless(GetParam()));
  const BodyId body = world.create_body(brick({0, 0, 0}));
  world.create_force_field(field(VortexForce{2, 5}));
  run(world, 40, dt);
  expect_near(world.body_state(body).angular_velocity, {0, 2 * (1 - std::exp(-5 * 0.4f)), 0}, 1e-3f);
}

TEST_P(ForceFieldsTest, AGridIsLinearBetweenItsNodes) {
  World world(weightless(GetParam(), 1));
  const FluidId water = world.create_fluid({});
  GridForce grid{{-1, 0, 0}, 0.5f, 5, 3, 2, {}};
  const auto at_node = [](Vec3 p) { return Vec3{p.x + 2 * p.y, 3 * p.z, 1 - p.x}; };
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 5; ++i)
        grid.values.push_back(at_node(grid.lower + 0.5f * Vec3{float(i), float(j), float(k)}));
  world.create_force_field(field(grid));
  const std::vector<Vec3> at{{-0.8f, 0.3f, 0.2f}, {1, 1, 0.5f}, {0.1f, 0.9f, 0}, {1.1f, 0.5f, 0.2f}};
  world.add_particles(water, at);
  world.step(dt);
  for (size_t k = 0; k < 3; ++k) expect_near(world.velocities()[k], dt * at_node(at[k]), 1e-6f);
  expect_near(world.velocities()[3], {0, 0, 0}, 1e-9f, "outside");
}

TEST_P(ForceFieldsTest, AForcePerVolumeGoesByTheDensity) {
  OneOfEach all(weightless(GetParam()));
  ForceFieldDef per_volume = field(UniformForce{{1000, 0, 0}});
  per_volume.quantity = ForceQuantity::force_density;
  all.world.create_force_field(per_volume);
  run(all.world, 10, dt);
  const std::vector<Vec3> v = all.velocities();
  const BodyMass mass = all.world.body_mass(all.body);
  EXPECT_NEAR(v[0].x, 0.1f, 1e-5f);
  EXPECT_NEAR(v[1].x, 100.0f / 1600, 1e-5f);
  EXPECT_NEAR(v[2].x, 100 * mass.volume / mass.mass, 1e-4f);
  EXPECT_NEAR(v[3].x, 0, 2e-4f) << "cloth without a given thickness has no volume";
  EXPECT_NEAR(v[4].x, 0.1f, 2e-4f) << "a rope has that of its radius";
}

TEST_P(ForceFieldsTest, AForcePerVolumeActsOnClothOfAGivenThickness) {
  World world(weightless(GetParam()));
  world.set_wind({.air_density = 0});
  ForceFieldDef per_volume = field(UniformForce{{1000, 0, 0}});
  per_volume.quantity = ForceQuantity::force_density;
  world.create_force_field(per_volume);
  ClothDef felt = sheet(0.4f, 0.4f, 4, 4, {0, 0, 0});
  felt.fabric.density = 0.8f;
  felt.fabric.thickness = 0.004f;  // 200 kg/m³
  const ClothId thick = world.create_cloth(felt);
  const ClothId late = world.create_cloth(sheet(0.4f, 0.4f, 4, 4, {0, 2, 0}));
  run(world, 10, dt);
  EXPECT_NEAR(world.cloth_velocities(thick)[7].x, 10 * dt * 1000 / 200, 1e-4f);
  EXPECT_NEAR(world.cloth_velocities(late)[7].x, 0, 1e-4f);
  world.destroy_cloth(late);  // numbers of vertices change with cloth
  felt.pose.position = {0, 4, 0};
  felt.fabric.density = 1.6f;
  const ClothId heavy = world.create_cloth(felt);
  run(world, 10, dt);
  EXPECT_NEAR(world.cloth_velocities(thick)[7].x, 20 * dt * 1000 / 200, 2e-4f);
  EXPECT_NEAR(world.cloth_velocities(heavy)[7].x, 10 * dt * 1000 / 400, 1e-4f);
}

TEST_P(ForceFieldsTest, EachKindOfTargetCanBeLeftOut) {
  bool ForceFieldDef::*const targets[] = {&ForceFieldDef::fluids, &ForceFieldDef::grains,
                                          &ForceFieldDef::bodies, &ForceFieldDef::cloth,
                                          &ForceFieldDef::cloth};
  for (bool ForceFieldDef::*const left_out : targets) {
    OneOfEach all(weightless(GetParam()));
    ForceFieldDef some = field(UniformForce{{1, 0, 0}});
    some.*left_out = false;
    all.world.create_force_field(some);
    run(all.world, 5, dt);
    const std::vector<Vec3> v = all.velocities();
    for (size_t k = 0; k < 5; ++k) EXPECT_EQ(v[k].x > 0.04f, targets[k] != left_out) << k;
  }
}

TEST_P(ForceFieldsTest, ARegionHoldsTheField) {
  OneOfEach all(weightless(GetParam()));
  ForceFieldDef some = field(UniformForce{{1, 0, 0}});
  some.region = BallRegion{1.5f};
  some.pose.position = {3, 0, 0};  // the grain and the body
  all.world.create_force_field(some);
  some.region = BoxRegion{{-1, -1, -1}, {1, 1, 1}};
  some.pose.position = {6, 0, 0};  // the cloth
  all.world.create_force_field(some);
  run(all.world, 5, dt);
  const std::vector<Vec3> v = all.velocities();
  for (size_t k = 0; k < 5; ++k) EXPECT_EQ(v[k].x > 0.04f, k == 1 || k == 2 || k == 3) << k;
}

TEST_P(ForceFieldsTest, HeldVerticesAndKinematicBodiesStay) {
  World world(weightless(GetParam()));
  const ClothId cloth = world.create_cloth(sheet(0.4f, 0.4f, 4, 4));
  world.create_attachment(attach(cloth, {0}));
  BodyDef def = brick({3, 0, 0});
  def.motion = BodyMotion::kinematic;
  const BodyId body = world.create_body(def);
  const Vec3 held = world.cloth_positions(cloth)[0];
  world.create_force_field(field(UniformForce{{0, -5, 0}}));
  run(world, 20, dt);
  expect_near(world.cloth_positions(cloth)[0], held, 1e-6f);
  expect_near(world.body_state(body).pose.position, {3, 0, 0}, 1e-6f);
}

TEST_P(ForceFieldsTest, FieldsAddUpAndCanChangeAndGo) {
  OneOfEach all(weightless(GetParam()));
  const ForceFieldId first = all.world.create_force_field(field(UniformForce{{1, 0, 0}}, "first"));
  const ForceFieldId second = all.world.create_force_field(field(UniformForce{{0, 1, 0}}, "second"));
  EXPECT_TRUE(all.world.find_force_field("second") == second);
  run(all.world, 10, dt);
  expect_near(all.velocities()[0], {0.1f, 0.1f, 0}, 1e-5f);
  all.world.set_force_field(first, field(UniformForce{{-1, 0, 0}}));
  all.world.destroy_force_field(second);
  EXPECT_EQ(all.world.force_field_ids().size(), 1u);
  run(all.world, 10, dt);
  expect_near(all.velocities()[0], {0, 0.1f, 0}, 1e-5f);
  expect_near(all.velocities()[2], {0, 0.1f, 0}, 1e-5f);
  expect_error(ErrorCode::not_found, "force field", [&] { all.world.destroy_force_field(second); });
  expect_error(ErrorCode::not_found, "third", [&] { all.world.find_force_field("third"); });
}

TEST_P(ForceFieldsTest, StrongFieldsGetMoreSubsteps) {
  WorldDef def = weightless(GetParam());
  def.cfl_number = 0.4f;
  OneOfEach all(def);
  EXPECT_EQ(all.world.step(dt).substeps, 1);
  all.world.create_force_field(field(UniformForce{{1900, 0, 0}}));
  EXPECT_EQ(all.world.step(dt).substeps, 5);  // dt² a / (0.4 h)
}

TEST_P(ForceFieldsTest, WithAnOriginFieldsAreWhereTheyWere) {
  WorldDef def = weightless(GetParam());
  def.origin = {1000, 0, 0};
  World world(def);
  const FluidId water = world.create_fluid({});
  world.add_particles(water, std::vector<Vec3>{{1000, 0, 0}, {1003, 0, 0}});
  ForceFieldDef some = field(RadialForce{1, 1, 0, 1e-3f});
  some.region = BallRegion{1};
  some.pose.position = {1003, -0.5f, 0};
  world.create_force_field(some);
  run(world, 5, dt);
  expect_near(world.velocities()[0], {0, 0, 0}, 1e-9f);
  expect_near(world.velocities()[1], {0, 0.05f, 0}, 1e-5f);
}

TEST_P(ForceFieldsTest, BadOnesAreRefusedByName) {
  World world(weightless(GetParam()));
  const auto refused = [&](const char* named, const ForceFieldDef& def) {
    expect_error(ErrorCode::invalid_argument, named, [&] { world.create_force_field(def); });
  };
  refused("RadialForce::exponent", field(RadialForce{1, 1, 5}));
  refused("RadialForce::softening", field(RadialForce{1, 1, 2, 0}));
  refused("DragForce::linear", field(DragForce{{0, 0, 0}, -1}));
  refused("NoiseForce::size", field(NoiseForce{1, 0}));
  refused("GridForce::values", field(GridForce{{0, 0, 0}, 1, 2, 2, 3, std::vector<Vec3>(11)}));
  refused("UniformForce::value", field(UniformForce{{NAN, 0, 0}}));
  ForceFieldDef vortex = field(VortexForce{});
  vortex.quantity = ForceQuantity::force_density;
  refused("ForceFieldDef::quantity", vortex);
  EXPECT_TRUE(world.force_field_ids().empty());
}

MENISCUS_ON_EACH_DEVICE(ForceFieldsTest);

}  // namespace
}  // namespace meniscus::tests
