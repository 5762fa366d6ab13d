// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Crates on a carpet, thousands of times heavier than the vertices between them and the ground.
#include <gtest/gtest.h>

#include "tests/cloth_worlds.h"
#include "tests/coupling/body_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float dt = 1 / 60.0f, gravity = 9.81f, half_height = 0.05f;

/// A square metre of .2 kg on the plane y = 0, which is a slope, and a crate on it.
class PinchedCloth : public OnDevice {
 protected:
  static World slope(pbd::DeviceKind device, float degrees, float friction = 0.8f, int iterations = 10) {
    WorldDef def = world_def(device, 0.02f);
    def.substeps = 4;
    def.iterations = iterations;
    const float angle = degrees * 3.14159265f / 180;
    def.gravity = {gravity * std::sin(angle), -gravity * std::cos(angle), 0};
    World world(def);
    ShapeDef ground = shape(PlaneGeometry{});
    ground.surface.friction = friction;
    world.create_shape(ground);
    return world;
  }
  static ClothId carpet(World& world) {
    ClothDef def = sheet(1, 1, columns, columns, {0, 0.004f, 0});
    return world.create_cloth(def);
  }
  static BodyId crate(World& world, float mass, float friction) {
    BodyDef def = body(BoxGeometry{{0.1f, half_height, 0.1f}}, {0, half_height + 0.01f, 0}, 100);
    def.mass = mass;
    def.surface.friction = friction;
    return world.create_body(def);
  }
  static float thickness() { return 0.25f * 1 / (columns - 1) * 1.138f; }  // of the mean edge, diagonals too

  static constexpr int columns = 33;
};

TEST_P(PinchedCloth, HoldsACrateOnASlope) {
  for (const float mass : {0.1f, 1.0f, 30.0f}) {
    World world = slope(GetParam(), 20);
    const ClothId cloth = carpet(world);
    const BodyId box = crate(world, mass, 0.5f);
    run(world, 30, dt);
    const BodyState before = world.body_state(box);
    run(world, 60, dt);
    const BodyState after = world.body_state(box);
    EXPECT_LT(after.pose.position.x - before.pose.position.x, 1e-4f) << mass << " kg";
    EXPECT_NEAR(after.pose.position.y, half_height + thickness(), 0.1f * thickness()) << mass << " kg";
    EXPECT_LT(world.cloth_state(cloth).max_stretch, 1.02f) << mass << " kg";
    EXPECT_LT(world.cloth_state(cloth).centre.x, 0.002f) << mass << " kg";
  }
}

// With two iterations as well.
TEST_P(PinchedCloth, HoldsACrateWithTwoIterations) {
  World world = slope(GetParam(), 20, 0.8f, 2);
  const ClothId cloth = carpet(world);
  const BodyId box = crate(world, 10, 0.5f);
  run(world, 60, dt);
  EXPECT_LT(world.body_state(box).pose.position.x, 0.03f);
  EXPECT_NEAR(world.body_state(box).pose.position.y, half_height + thickness(), 0.1f * thickness());
  EXPECT_LT(world.cloth_state(cloth).max_stretch, 1.02f);
}

TEST_P(PinchedCloth, LetsACrateSlideByCoulombsLaw) {
  constexpr float degrees = 35, friction = 0.5f, angle = degrees * 3.14159265f / 180;
  World world = slope(GetParam(), degrees, 1);
  carpet(world);
  const BodyId box = crate(world, 3, friction);
  run(world, 20, dt);
  const float before = world.body_state(box).velocity.x;
  run(world, 12, dt);
  const float gain = (world.body_state(box).velocity.x - before) / (12 * dt);
  const float wanted = gravity * (std::sin(angle) - friction * std::cos(angle));
  EXPECT_NEAR(gain, wanted, 0.06f * wanted);
}

/// A kinematic bar that holds one edge of a square carpet with so many columns.
BodyId bar_at_the_edge(World& world, ClothId cloth, uint32_t columns) {
  const BodyId bar = world.create_body(kinematic(BoxGeometry{{0.01f, 0.01f, 0.5f}}, {0.6f, 0.3f, 0}));
  AttachmentDef edge = attach(cloth, {});
  for (uint32_t row = 0; row < columns; ++row) edge.vertices.push_back(columns * row + columns - 1);
  edge.body = bar;
  world.create_attachment(edge);
  return bar;
}

// What is drawn from under it takes it along by μ g.
TEST_P(PinchedCloth, TakesAlongWhatStandsOnIt) {
  constexpr float friction = 0.3f, speed = 1;
  World world = slope(GetParam(), 0, 0.1f);
  const ClothId cloth = carpet(world);
  const BodyId box = crate(world, 1, friction);
  const BodyId bar = bar_at_the_edge(world, cloth, columns);
  run(world, 20, dt);
  world.move_body(bar, {{0.6f + 0.2f * speed, 0.3f, 0}, {0, 0, 0, 1}}, 0.2f);
  run(world, 12, dt);
  EXPECT_NEAR(world.body_state(box).velocity.x, friction * gravity * 0.2f, 0.06f * friction * gravity * 0.2f);
  EXPECT_NEAR(world.cloth_state(cloth).centre.x, 0.2f * speed, 0.01f);
  EXPECT_LT(world.cloth_state(cloth).max_stretch, 1.02f);
}

// With nine tenths of μ g it goes along without slip, and stays in its place.
TEST_P(PinchedCloth, CarriesWhatStandsOnItAlong) {
  constexpr float friction = 0.3f, pull = 0.9f * friction * gravity;  // m/s²
  World world = slope(GetParam(), 0, 0.1f);
  const ClothId cloth = carpet(world);
  const BodyId box = crate(world, 1, friction);
  const BodyId bar = bar_at_the_edge(world, cloth, columns);
  run(world, 20, dt);
  const float start = world.body_state(box).pose.position.x;
  constexpr int steps = 24;
  for (int k = 1; k <= steps; ++k) {
    const float t = float(k) * dt;
    world.move_body(bar, {{0.6f + 0.5f * pull * t * t, 0.3f, 0}, {0, 0, 0, 1}}, dt);
    world.step(dt);
  }
  const float time = steps * dt, moved = world.body_state(box).pose.position.x - start;
  EXPECT_NEAR(moved, 0.5f * pull * time * time, 0.015f);
  EXPECT_NEAR(world.body_state(box).velocity.x, pull * time, 0.05f * pull * time);
}

MENISCUS_ON_EACH_DEVICE(PinchedCloth);

}  // namespace
}  // namespace meniscus::tests
