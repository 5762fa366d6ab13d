// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Changes while a world runs: its definition and its fluids, and impulses by the user.
#include <gtest/gtest.h>

#include "tests/cloth_worlds.h"
#include "tests/expect_error.h"
#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

class WorldChangesTest : public OnDevice {
 protected:
  WorldDef def() const { return world_def(GetParam(), 0.1f); }
  WorldDef weightless() const {
    WorldDef d = def();
    d.gravity = {0, 0, 0};
    return d;
  }
  /// A block of water on a floor, with a ball above it.
  static World pool(const WorldDef& def, const FluidDef& fluid) {
    World world(def);
    const FluidId water = world.create_fluid(fluid);
    world.create_shape(tank({-0.4f, 0, -0.4f}, {0.4f, 2, 0.4f}));
    world.add_fluid(block(water, {-0.4f, 0, -0.4f}, {0.2f, 0.5f, 0.4f}));
    BodyDef ball;
    ball.geometry = SphereGeometry{0.15f};
    ball.pose.position = {0, 0.8f, 0};
    world.create_body(ball);
    return world;
  }
  /// Of the first fluid: ids of one world are made alike.
  static FluidId water_of(World& world) { return {0, world.create_fluid({}).generation}; }
};

TEST_P(WorldChangesTest, WhatWasChangedIsAsIfItHadBeenSoFromTheStart) {
  FluidDef honey;
  honey.dynamic_viscosity = 28;
  honey.surface_tension = 0.5f;
  WorldDef changed = def();
  changed.gravity = {1, -5, 0};
  changed.substeps = 6;
  changed.iterations = 4;
  changed.density.solver = DensitySolver::jacobi;
  changed.density.spectral_bound = 5;
  changed.rigid.iterations = 20;
  World from_start = pool(changed, honey), later = pool(def(), {});
  from_start.create_fluid({});
  later.set_def(changed);
  later.set_fluid(water_of(later), honey);
  EXPECT_EQ(later.def().gravity.x, 1);
  for (int step = 0; step < 5; ++step) {
    from_start.step(0.01f);
    later.step(0.01f);
  }
  EXPECT_EQ(later.state_hash(), from_start.state_hash());
}

TEST_P(WorldChangesTest, ABodyThatSleptFallsTheNewWay) {
  World world(def());
  world.create_shape(shape(PlaneGeometry{}));
  BodyDef box;
  box.geometry = BoxGeometry{{0.2f, 0.2f, 0.2f}};
  box.pose.position = {0, 0.2f, 0};
  const BodyId id = world.create_body(box);
  for (int step = 0; step < 400 && world.body_state(id).awake; ++step) world.step(0.01f);
  ASSERT_FALSE(world.body_state(id).awake);
  WorldDef up = world.def();
  up.gravity = {0, 2, 0};
  world.set_def(up);
  for (int step = 0; step < 50; ++step) world.step(0.01f);
  EXPECT_NEAR(world.body_state(id).velocity.y, 1.0f, 0.02f);
}

TEST_P(WorldChangesTest, AnImpulseIsMomentumForThatParticleAlone) {
  World world(weightless());
  const FluidId water = world.create_fluid({});
  std::vector<Vec3> places;
  for (int i = 0; i < 100; ++i) places.push_back({static_cast<float>((i * 37) % 100), 0, 0});
  world.add_particles(water, places);
  world.step(0.01f);  // sorts them
  const ParticleId pushed[] = {70, 3, 41};
  const Vec3 impulses[] = {{2, 0, 0}, {0, -1, 0}, {0, 0, 4}};
  world.apply_impulses(pushed, impulses);
  const float mass = world.particle_mass(water);
  for (std::size_t i = 0; i < 100; ++i) {
    Vec3 wanted{0, 0, 0};
    for (int k = 0; k < 3; ++k) {
      if (world.ids()[i] == pushed[k]) wanted = impulses[k] / mass;
    }
    EXPECT_NEAR(length(world.velocities()[i] - wanted), 0, 1e-5f) << i;
  }
  const float before = world.positions()[70].x;
  world.step(0.01f);
  EXPECT_NEAR(world.positions()[70].x - before, 0.01f * 2 / mass, 1e-4f);
}

TEST_P(WorldChangesTest, VerticesThatAreHeldTakeNoImpulse) {
  World world(weightless());
  world.create_fluid({});
  ClothDef def;
  def.geometry = SheetGeometry{1, 1, 3, 3};
  const ClothId first = world.create_cloth(def);
  def.pose.position = {0, 1, 0};
  const ClothId second = world.create_cloth(def);
  AttachmentDef hold;
  hold.cloth = second;
  hold.vertices = {0};
  world.create_attachment(hold);
  const uint32_t vertices[] = {8, 0};
  const Vec3 impulses[] = {{0, 0.3f, 0}, {0, 0.3f, 0}};
  world.apply_impulses(second, vertices, impulses);
  const ClothState state = world.cloth_state(second);
  EXPECT_NEAR(state.momentum.y, 0.3f, 1e-6f);
  EXPECT_GT(world.cloth_velocities(second)[8].y, 1);
  EXPECT_EQ(world.cloth_velocities(second)[0].y, 0);
  EXPECT_EQ(world.cloth_state(first).momentum.y, 0);
  world.step(0.001f);
  EXPECT_GT(world.cloth_velocities(second)[8].y, 0.5f);
}

TEST_P(WorldChangesTest, RopesTakeImpulses) {
  World world(weightless());
  RopeDef def;
  def.points = {{0, 0, 0}, {1, 0, 0}};
  def.segments = 10;
  const RopeId id = world.create_rope(def);
  const uint32_t vertices[] = {10};
  const Vec3 impulses[] = {{0, 0, 0.01f}};
  world.apply_impulses(id, vertices, impulses);
  EXPECT_GT(world.rope_velocities(id)[10].z, 0.1f);
  EXPECT_EQ(world.rope_velocities(id)[9].z, 0);
}

TEST_P(WorldChangesTest, DistancesToSolidsAreThoseOfTheirShapes) {
  World world(def());
  world.create_shape(shape(PlaneGeometry{}));
  world.create_shape(shape(SphereGeometry{0.5f}, {0, 2, 0}));
  BodyDef box;
  box.geometry = BoxGeometry{{0.5f, 0.5f, 0.5f}};
  box.pose.position = {3, 2, 0};
  world.create_body(box);
  const Vec3 points[] = {{-5, 0.3f, 0}, {0, 3, 0}, {0, 1.7f, 0}, {3, 2.75f, 0}, {0, 50, 0}};
  const std::vector<float> found = world.solid_distances(points, 2);
  const float wanted[] = {0.3f, 0.5f, -0.2f, 0.25f, 2};
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(found[i], wanted[i], 1e-5f) << i;
  EXPECT_EQ(world.solid_distances(points, 2, {1, 0})[0], 2);  // which collides with nothing
}

// The box of a height field is deep, and floats are coarse in the middle of it.
TEST_P(WorldChangesTest, SmallParticlesAreNearTheTopOfAHeightField) {
  World world(world_def(GetParam(), 0.005f));
  for (const float top : {0.34f, 0.3f, 1.77f, -2.13f}) {
    ShapeDef ground = shape(HeightFieldGeometry{11, 11, 0.05f, std::vector<float>(121, top)});
    if (top == 0.3f) ground.pose.rotation = about_z(30);
    const ShapeId id = world.create_shape(ground);
    const Vec3 out = rotate(ground.pose.rotation, {0, 1, 0});
    const Vec3 points[] = {(top + 0.002f) * out, (top - 0.002f) * out, (top - 40) * out};
    const std::vector<float> found = world.solid_distances(points, 0.01f);
    EXPECT_NEAR(found[0], 0.002f, 1e-5f) << top;
    EXPECT_NEAR(found[1], -0.002f, 1e-5f) << top;
    EXPECT_LT(found[2], 0) << top;
    world.destroy_shape(id);
  }
}

TEST_P(WorldChangesTest, WhatCannotChangeIsRefused) {
  World world(def());
  const FluidId water = world.create_fluid({});
  WorldDef other = world.def();
  other.particle_spacing = 0.2f;
  expect_error(ErrorCode::invalid_argument, "particle_spacing", [&] { world.set_def(other); });
  other = world.def();
  other.diffuse = DiffuseDef{};
  expect_error(ErrorCode::invalid_argument, "diffuse", [&] { world.set_def(other); });
  other = world.def();
  other.kernel = SmoothingKernel::wendland_c2;
  expect_error(ErrorCode::invalid_argument, "kernel", [&] { world.set_def(other); });
  other = world.def();
  other.density.relaxation = 2;
  expect_error(ErrorCode::invalid_argument, "relaxation", [&] { world.set_def(other); });
  FluidDef heavy;
  heavy.rest_density = 1200;
  expect_error(ErrorCode::invalid_argument, "rest_density", [&] { world.set_fluid(water, heavy); });
  const FluidId sand = world.create_granular({});
  expect_error(ErrorCode::invalid_argument, "fluids alone", [&] { world.set_fluid(sand, {}); });
}

TEST_P(WorldChangesTest, ImpulsesBeyondAnySpeedAreRefused) {
  World world(def());
  const ParticleId drop = world.add_particles(world.create_fluid({}), std::vector<Vec3>{{9, 0, 0}});
  const ClothId cloth = world.create_cloth(sheet(1, 1, 3, 3));
  BodyDef box;
  box.pose.position = {0, 9, 0};
  const BodyId body = world.create_body(box);
  const Vec3 huge[] = {{3e38f, 0, 0}};
  const ParticleId drops[] = {drop};
  const uint32_t vertices[] = {0};
  expect_error(ErrorCode::invalid_argument, "1e9 m/s", [&] { world.apply_impulses(drops, huge); });
  expect_error(ErrorCode::invalid_argument, "1e9 m/s", [&] { world.apply_impulses(cloth, vertices, huge); });
  expect_error(ErrorCode::invalid_argument, "1e9 m/s", [&] { world.apply_impulse(body, huge[0], {}); });
  // Of the particle's own mass: another fluid may be lighter by far.
  FluidDef thin;
  thin.rest_density = 0.001f;
  world.create_fluid(thin);
  const Vec3 firm[] = {{2000, 0, 0}};
  world.apply_impulses(drops, firm);
  EXPECT_EQ(world.diagnostics().non_finite, 0u);
  world.step(0.01f);
}

TEST_P(WorldChangesTest, ImpulsesThatMakeNoSenseAreRefused) {
  World world(def());
  const FluidId water = world.create_fluid({});
  world.add_particles(water, lattice(2, 2, 2, 0.1f, {0, 0, 0}));
  ClothDef sheet;
  sheet.geometry = SheetGeometry{1, 1, 3, 3};
  const ClothId cloth = world.create_cloth(sheet);
  const uint64_t before = world.state_hash();
  const Vec3 pushes[] = {{1, 0, 0}, {1, 0, 0}};
  const ParticleId twice[] = {1, 1}, unknown[] = {1, 8};
  expect_error(ErrorCode::invalid_argument, "1 twice", [&] { world.apply_impulses(twice, pushes); });
  expect_error(ErrorCode::not_found, "8", [&] { world.apply_impulses(unknown, pushes); });
  expect_error(ErrorCode::invalid_argument, "2 impulses for 1",
               [&] { world.apply_impulses(std::span(twice).first(1), pushes); });
  const Vec3 endless[] = {{INFINITY, 0, 0}, {1, 0, 0}};
  expect_error(ErrorCode::invalid_argument, "finite", [&] { world.apply_impulses(unknown, endless); });
  const uint32_t beyond[] = {0, 9};
  expect_error(ErrorCode::invalid_argument, "vertex 9, but the cloth has 9",
               [&] { world.apply_impulses(cloth, beyond, pushes); });
  expect_error(ErrorCode::invalid_argument, "reach", [&] { world.solid_distances(pushes, 0); });
  EXPECT_EQ(world.state_hash(), before);
}

MENISCUS_ON_EACH_DEVICE(WorldChangesTest);

}  // namespace
}  // namespace meniscus::tests
