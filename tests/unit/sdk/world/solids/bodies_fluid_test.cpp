// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Bodies among particles: seeding, what counts as outside, adhesion, and a step's memory.
#include <gtest/gtest.h>

#include "tests/unit/sdk/world/solids/body_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float dt = 0.01f, s = 0.05f;

class BodyFluidTest : public OnDevice {
 protected:
  World world_{world_def(GetParam(), s)};

  bool any_within(Vec3 centre, float half) const {
    for (Vec3 p : world_.positions()) {
      if (max_component(abs(p - centre)) < half) return true;
    }
    return false;
  }
};

TEST_P(BodyFluidTest, FluidIsNotSeededInsideABody) {
  const FluidId water = world_.create_fluid({});
  const BodyId id = world_.create_body(body(BoxGeometry{{0.1f, 0.1f, 0.1f}}, {5, 0, 0}));
  world_.set_body_pose(id, {{0, 0, 0}});  // where it is now counts
  // A lattice of 10³ with points at odd multiples of s/2: the body and half a spacing around it hold 4³.
  EXPECT_EQ(world_.add_fluid(block(water, {-0.25f, -0.25f, -0.25f}, {0.25f, 0.25f, 0.25f})), 1000u - 64u);
  EXPECT_FALSE(any_within({0, 0, 0}, 0.1f + 0.49f * s));
  EXPECT_EQ(world_.diagnostics().outside, 0u);
}

TEST_P(BodyFluidTest, DiagnosticsCountParticlesInsideBodies) {
  world_.add_particles(world_.create_fluid({}), lattice(10, 10, 10, s, {-0.25f, -0.25f, -0.25f}));
  EXPECT_EQ(world_.diagnostics().outside, 0u);
  const BodyId id = world_.create_body(body(BoxGeometry{{0.11f, 0.11f, 0.11f}}));
  EXPECT_EQ(world_.diagnostics().outside, 64u);
  world_.set_body_pose(id, {{0.25f, 0, 0}});  // half of it is in the water, 2 of 10 layers
  EXPECT_EQ(world_.diagnostics().outside, 32u);
  world_.set_body_pose(id, {{3, 0, 0}});
  EXPECT_EQ(world_.diagnostics().outside, 0u);
  world_.set_body_pose(id, {{0, 0, 0}, about_z(90)});
  EXPECT_EQ(world_.diagnostics().outside, 64u);
  world_.destroy_body(id);
  EXPECT_EQ(world_.diagnostics().outside, 0u);
}

// Particles see a body's geometry where a fixed shape of the same pose would have it.
TEST_P(BodyFluidTest, ABodyIsWhereAFixedShapeOfItsPoseWouldBe) {
  TemporaryFolder folder;
  MeshGeometry brick{folder.write("brick.obj", brick_obj)};
  brick.scale = 0.1f;
  const Quat slant = normalized({0.3f, -0.2f, 0.5f, 0.7f});
  const auto turned = [&](const Geometry& part) {
    CompoundGeometry compound;
    compound.parts.push_back({part, {{0.1f, -0.05f, 0.07f}, slant}});
    return compound;
  };
  CompoundGeometry two = turned(SphereGeometry{0.1f});
  two.parts.push_back({BoxGeometry{{0.05f, 0.1f, 0.2f}}, {{-0.1f, 0, 0.1f}, about_z(30)}});
  const BoxGeometry box{{0.05f, 0.2f, 0.1f}};
  const HullGeometry hull{{{0, 0, 0}, {0.4f, 0, 0}, {0, 0.3f, 0}, {0, 0, 0.2f}, {0.2f, 0.2f, 0.2f}}};
  world_.add_particles(world_.create_fluid({}), lattice(24, 24, 24, s, {-0.6f, -0.6f, -0.6f}));
  for (const Geometry& geometry :
       {Geometry{box}, Geometry{CapsuleGeometry{0.1f, 0.2f}}, Geometry{CylinderGeometry{0.1f, 0.2f}},
        Geometry{brick}, Geometry{hull}, Geometry{turned(box)}, Geometry{turned(brick)},
        Geometry{turned(hull)}, Geometry{turned(CapsuleGeometry{0.1f, 0.2f})},
        Geometry{turned(CylinderGeometry{0.2f, 0.05f})}, Geometry{two}}) {
    const Pose pose{{0.013f, 0.021f, -0.017f}, about_z(40)};
    ShapeDef fixed = shape(geometry);
    fixed.pose = pose;
    const ShapeId shape_id = world_.create_shape(fixed);
    const size_t expected = world_.diagnostics().outside;
    world_.destroy_shape(shape_id);
    EXPECT_GT(expected, 5u);
    for (BodyMotion motion : {BodyMotion::dynamic, BodyMotion::kinematic}) {
      BodyDef def = body(geometry);
      def.motion = motion;
      def.pose = pose;
      const BodyId id = world_.create_body(def);
      EXPECT_EQ(world_.diagnostics().outside, expected) << geometry.index() << ' ' << int(motion);
      world_.destroy_body(id);
    }
  }
}

TEST_P(BodyFluidTest, NoParticleEndsUpInsideAFallingBody) {
  world_.create_shape(open_tank({0.25f, 0.5f, 0.25f}));
  world_.add_fluid(block(world_.create_fluid({}), {-0.25f, 0, -0.25f}, {0.25f, 0.3f, 0.25f}));
  BodyDef def = body(BoxGeometry{{0.1f, 0.1f, 0.1f}}, {0, 0.45f, 0});
  def.density = 2000;
  def.velocity = {0, -3, 0};
  def.angular_velocity = {3, 0, 5};
  world_.create_body(def);
  for (int k = 0; k < 60; ++k) {
    world_.step(dt);
    ASSERT_EQ(world_.diagnostics().outside, 0u) << k;
  }
}

// A sheet of two layers below a plate: 600 Pa hold up 1000 kg/m³ · g · 2 s = 981 Pa or do not; 3000 do.
TEST_P(BodyFluidTest, ADropHangsUnderAPlateThatItSticksTo) {
  for (bool sticky : {false, true}) {
    for (bool of_body : {false, true}) {
      World world(world_def(GetParam(), s));
      FluidDef water;
      water.cohesion = 1;
      const FluidId fluid = world.create_fluid(water);
      const BoxGeometry plate{{0.3f, 0.05f, 0.3f}};
      SurfaceDef surface;
      surface.adhesion = sticky ? 3000.0f : 0.0f;
      if (of_body) {
        BodyDef def = kinematic(plate, {0, 0.05f, 0});
        def.surface = surface;
        world.create_body(def);
      } else {
        ShapeDef def = shape(plate, {0, 0.05f, 0});
        def.surface = surface;
        world.create_shape(def);
      }
      world.add_particles(fluid, lattice(4, 1, 4, s, {-0.1f, -s, -0.1f}));
      run(world, 60, dt);
      size_t hanging = 0;
      for (Vec3 p : world.positions()) hanging += p.y > -2 * s;
      EXPECT_EQ(hanging, sticky ? world.particle_count() : 0u) << of_body;
    }
  }
}

// What hangs on a body pulls it down.
TEST_P(BodyFluidTest, AdhesionPullsTheBodyAsMuch) {
  WorldDef def = world_def(GetParam(), s);
  def.substeps = 8;
  World world(def);
  BodyDef plate = kinematic(BoxGeometry{{0.3f, 0.05f, 0.3f}}, {0, 0.05f, 0});
  plate.surface.adhesion = 3000;
  const BodyId id = world.create_body(plate);
  const FluidId water = world.create_fluid({});
  world.add_particles(water, lattice(4, 1, 4, s, {-0.1f, -s, -0.1f}));
  run(world, 100, dt);
  const float weight = 16 * world.particle_mass(water) * 9.81f;
  EXPECT_NEAR(world.body_state(id).fluid_force.y, -weight, 0.02f * weight);
}

TEST_P(BodyFluidTest, AWarmStepHoldsTheSameMemoryOnTheDevice) {
  world_.create_shape(open_tank({0.25f, 0.5f, 0.25f}));
  world_.add_fluid(block(world_.create_fluid({}), {-0.25f, 0, -0.25f}, {0.25f, 0.3f, 0.25f}));
  for (float x : {-0.1f, 0.1f}) world_.create_body(body(SphereGeometry{0.08f}, {x, 0.35f, 0}));
  BodyDef stirrer = kinematic(BoxGeometry{{0.1f, 0.02f, 0.02f}}, {0, 0.1f, 0});
  stirrer.keyframes = {{0, {{0, 0.1f, 0}}}, {0.5f, {{0, 0.1f, 0.1f}}}, {1, {{0, 0.1f, 0}}}};
  stirrer.loop = true;
  world_.create_body(stirrer);
  run(world_, 100, dt);
  const size_t held = world_.device_bytes();
  for (int k = 0; k < 50; ++k) {
    world_.step(dt);
    ASSERT_EQ(world_.device_bytes(), held) << k;
  }
}

TEST_P(BodyFluidTest, BodiesGiveTheirMemoryBack) {
  TemporaryFolder folder;
  MeshGeometry brick{folder.write("brick.obj", brick_obj)};
  brick.scale = 0.2f;
  world_.add_particles(world_.create_fluid({}), lattice(4, 4, 4, s, {2, 0, 0}));
  const auto come_and_go = [&] {
    const BodyId id = world_.create_body(body(brick));
    world_.step(dt);
    world_.destroy_body(id);
  };
  come_and_go();
  const size_t held = world_.device_bytes();
  for (int k = 0; k < 5; ++k) come_and_go();
  EXPECT_LE(world_.device_bytes(), held);
}

// A push that was asked for counts, whatever else is done before the step, and also where the step runs out
// of room and is done again.
TEST_P(BodyFluidTest, AForceIsNotForgottenBeforeItsStep) {
  const BodyId id = world_.create_body(body(BoxGeometry{{0.1f, 0.1f, 0.1f}}, {9, 0, 0}));
  const float mass = world_.body_mass(id).mass;
  const auto expect_pushed = [&](const char* after, const auto& meanwhile) {
    world_.set_body_pose(id, {{9, 0, 0}});
    world_.set_body_velocity(id, {0, 0, 0}, {0, 0, 0});
    world_.apply_force(id, {mass, 0, 0}, {9, 0, 0});
    meanwhile();
    world_.step(dt);
    EXPECT_NEAR(world_.body_state(id).velocity.x, dt, 1e-6f) << after;
  };
  expect_pushed("nothing", [] {});
  expect_pushed("create_shape", [&] { world_.create_shape(shape(BoxGeometry{}, {0, 50, 0})); });
  expect_pushed("create_body", [&] { world_.create_body(body(BoxGeometry{}, {0, 60, 0})); });
  expect_pushed("set_body_pose", [&] { world_.set_body_pose(id, {{9, 0, 0}}); });
  expect_pushed("diagnostics", [&] { world_.diagnostics(); });
  expect_pushed("a step that is done again", [&] {
    // A heap of particles in one place: more neighbours than there is room for.
    world_.add_particles(world_.create_fluid({}), std::vector<Vec3>(300, Vec3{0, 0, 0}));
  });
}

MENISCUS_ON_EACH_DEVICE(BodyFluidTest);

}  // namespace
}  // namespace meniscus::tests
