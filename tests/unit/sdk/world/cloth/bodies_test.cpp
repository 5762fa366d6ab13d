// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cloth that supports bodies many times its weight.
#include <gtest/gtest.h>

#include <iterator>

#include "tests/cloth_worlds.h"
#include "tests/unit/sdk/world/solids/body_worlds.h"

namespace meniscus::tests {
namespace {

class LoadedClothTest : public OnDevice {};
MENISCUS_ON_EACH_DEVICE(LoadedClothTest);

constexpr int columns = 33;

std::vector<uint32_t> border() {
  std::vector<uint32_t> vertices;
  for (uint32_t v = 0; v < columns * columns; ++v) {
    if (v / columns % (columns - 1) == 0 || v % columns % (columns - 1) == 0) vertices.push_back(v);
  }
  return vertices;
}

std::vector<uint32_t> corners() {
  return {0, columns - 1, columns * (columns - 1), columns * columns - 1};
}

struct Borne {
  float stretch = 0;     ///< the most of any edge, ever
  float mean_push = 0;   ///< of the weight, over the last second
  Vec3 centre{0, 0, 0};  ///< m, in the end
};

/// A ball that falls onto a square metre of cloth, .2 kg.
Borne fall_on_sheet(pbd::DeviceKind device, const std::vector<uint32_t>& held, float mass, int iterations) {
  WorldDef def = world_def(device, 0.05f);
  def.substeps = 4;
  def.iterations = iterations;
  World world(def);
  const ClothId id = world.create_cloth(sheet(1, 1, columns, columns));
  world.create_attachment(attach(id, held));
  BodyDef ball = body(SphereGeometry{0.15f}, {0, 0.16f, 0});
  ball.mass = mass;
  ball.can_sleep = false;
  const BodyId load = world.create_body(ball);
  Borne borne;
  for (int k = 0; k < 180; ++k) {
    world.step(1 / 60.0f);
    borne.stretch = std::max(borne.stretch, world.cloth_state(id).max_stretch);
    if (k >= 120) borne.mean_push += world.body_state(load).fluid_force.y / (60 * mass * 9.81f);
  }
  borne.centre = world.body_state(load).centre_of_mass;
  return borne;
}

TEST_P(LoadedClothTest, AHeavyBallLiesInATrampoline) {
  for (float mass : {0.3f, 3.0f}) {
    const Borne borne = fall_on_sheet(GetParam(), border(), mass, 10);
    EXPECT_LT(borne.stretch, 1.5f) << mass;
    EXPECT_NEAR(borne.mean_push, 1, 0.1f) << mass;
    EXPECT_GT(borne.centre.y, 0.05f) << mass;
  }
}

/// The worst edge is at 1.6 to 2.2 of its length at the impact, whichever the mass.
TEST_P(LoadedClothTest, OneOfFiftyTimesItsWeightAsWell) {
  constexpr float masses[] = {9, 9.5f, 10, 10.5f, 11};
  float mean_stretch = 0;
  for (float mass : masses) {
    const Borne borne = fall_on_sheet(GetParam(), border(), mass, 10);
    mean_stretch += borne.stretch / std::size(masses);
    EXPECT_NEAR(borne.mean_push, 1, 0.2f) << mass;
    EXPECT_GT(borne.centre.y, 0) << mass;
  }
  EXPECT_LT(mean_stretch, 2.1f);
}

TEST_P(LoadedClothTest, FewIterationsBearItToo) {
  const Borne borne = fall_on_sheet(GetParam(), border(), 3, 4);
  EXPECT_LT(borne.stretch, 1.9f);
  EXPECT_NEAR(borne.mean_push, 1, 0.1f);
  EXPECT_GT(borne.centre.y, 0.05f);
}

TEST_P(LoadedClothTest, ASheetHeldByItsCornersBearsABallInItsMiddle) {
  const Borne borne = fall_on_sheet(GetParam(), corners(), 1, 10);
  EXPECT_LT(borne.stretch, 1.4f);
  EXPECT_NEAR(borne.mean_push, 1, 0.2f);
  EXPECT_GT(borne.centre.y, -0.15f);
  EXPECT_NEAR(borne.centre.x, 0, 0.03f);
  EXPECT_NEAR(borne.centre.z, 0, 0.03f);
}

enum class Elsewhere { nothing, body, fluid, fluid_on_cloth };

/// 99th percentile of the stretch of a sheet that has fallen onto a ball, with a corner attached to a
/// kinematic one.
double stretch_on_ball(pbd::DeviceKind device, Elsewhere elsewhere) {
  WorldDef def = world_def(device, 0.05f);
  def.substeps = 4;
  def.iterations = 10;
  World world(def);
  world.create_shape(shape(SphereGeometry{0.3f}, {0, -0.35f, 0}));
  const ClothId id = world.create_cloth(sheet(1, 1, columns, columns));
  const std::vector<Vec3> rest = copy_of(world.cloth_positions(id));
  BodyDef still = body(SphereGeometry{0.05f}, {1, 1, 1});
  still.motion = BodyMotion::kinematic;
  AttachmentDef corner = attach(id, {0});
  corner.body = world.create_body(still);
  world.create_attachment(corner);
  if (elsewhere == Elsewhere::body) world.create_body(body(SphereGeometry{0.1f}, {5, 0, 0}));
  if (elsewhere == Elsewhere::fluid || elsewhere == Elsewhere::fluid_on_cloth)
    world.add_fluid(block(world.create_fluid({}), {5, 0, 0}, {5.2f, 0.2f, 0.2f}));
  if (elsewhere == Elsewhere::fluid_on_cloth) {
    const ClothId other = world.create_cloth(sheet(0.5f, 0.5f, 11, 11, {5.1f, -0.1f, 0.1f}));
    world.create_attachment(attach(other, {0, 10, 110, 120}));
  }
  run(world, 36, 1 / 60.0f);
  return percentile(edge_stretches(world, id, rest), 0.99);
}

/// What it pulled with in the last substep does not fit the masses of this one.
TEST_P(LoadedClothTest, UnderWaterItStartsFromNothing) {
  constexpr int fine = 41;
  WorldDef def = world_def(GetParam(), 0.04f);
  def.substeps = 4;
  def.iterations = 4;
  World world(def);
  const ClothId id = world.create_cloth(sheet(1, 1, fine, fine));
  std::vector<uint32_t> held;
  for (uint32_t v = 0; v < fine * fine; ++v) {
    if (v / fine % (fine - 1) == 0 || v % fine % (fine - 1) == 0) held.push_back(v);
  }
  world.create_attachment(attach(id, held));
  world.add_fluid(block(world.create_fluid({}), {-0.4f, 0.02f, -0.4f}, {0.4f, 0.3f, 0.4f}));
  float most = 0;
  for (int k = 0; k < 20 && most < 2; ++k) {
    world.step(1 / 60.0f);
    most = std::max(most, world.cloth_state(id).max_stretch);
  }
  EXPECT_LT(most, 1.4f);
}

TEST_P(LoadedClothTest, WhatLiesElsewhereIsNothingToIt) {
  const double alone = stretch_on_ball(GetParam(), Elsewhere::nothing) - 1;
  EXPECT_LT(alone, 0.05);
  for (const Elsewhere elsewhere : {Elsewhere::body, Elsewhere::fluid, Elsewhere::fluid_on_cloth}) {
    SCOPED_TRACE(static_cast<int>(elsewhere));
    EXPECT_NEAR(stretch_on_ball(GetParam(), elsewhere) - 1, alone, 0.1 * alone);
  }
}

}  // namespace
}  // namespace meniscus::tests
