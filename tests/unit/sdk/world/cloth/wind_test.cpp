// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Wind carries free cloth along, and exerts pressure on cloth that is held.
#include <gtest/gtest.h>

#include "tests/cloth_worlds.h"
#include "tests/unit/sdk/world/solids/body_worlds.h"

namespace meniscus::tests {
namespace {

class ClothWindTest : public OnDevice {
 protected:
  /// Air and a sheet of 0.5 m², lying or upright, that a body holds by all of its vertices.
  struct Plate {
    explicit Plate(pbd::DeviceKind device, const FabricDef& fabric, const Quat& turn = {0, 0, 0, 1})
        : world(weightless(device)) {
      ClothDef def = sheet(1, 0.5f, 5, 3);
      def.fabric = fabric;
      def.pose.rotation = turn;
      const ClothId cloth = world.create_cloth(def);
      AttachmentDef grip = attach(cloth, vertices_from(0, 15));
      grip.body = world.create_body(kinematic(SphereGeometry{0.01f}, {0, -3, 0}));
      held = world.create_attachment(grip);
    }
    Vec3 force(const WindDef& wind) {
      world.set_wind(wind);
      run(world, 5, 0.01f);
      return world.attachment_force(held);
    }

    World world;
    AttachmentId held;
  };

  static FabricDef coefficients(float drag, float lift) {
    FabricDef f;
    f.drag = drag;
    f.lift = lift;
    return f;
  }
};

TEST_P(ClothWindTest, APlateFaceOnFeelsItsDrag) {
  Plate plate(GetParam(), coefficients(1.3f, 0.5f));
  for (float speed : {2.0f, -6.0f}) {
    const float expected = 0.5f * 1.2f * 1.3f * 0.5f * speed * std::fabs(speed);
    const Vec3 force = plate.force({.velocity = {0, speed, 0}});
    expect_near(force, {0, expected, 0}, 0.01f * std::fabs(expected));
  }
}

// ½ ρ A (C_D |u·n| u + C_L (u·n) (|u| n − (u·n) u/|u|)).
TEST_P(ClothWindTest, APlateAtAnAngleFeelsDragAndLift) {
  constexpr float speed = 4;
  const float pressure = 0.5f * 1.2f * 0.5f * speed * speed, sine = 0.5f, cosine = std::sqrt(0.75f);
  const Vec3 wind{speed * cosine, speed * sine, 0};
  Plate drags(GetParam(), coefficients(0.8f, 0)), lifts(GetParam(), coefficients(0, 0.8f));
  const float scale = 0.8f * pressure * sine;
  expect_near(drags.force({.velocity = wind}), {scale * cosine, scale * sine, 0}, 0.01f * scale);
  const Vec3 lift = lifts.force({.velocity = wind});
  expect_near(lift, {-scale * sine * cosine, scale * (1 - sine * sine), 0}, 0.01f * scale);
  EXPECT_NEAR(dot(lift, wind), 0, 0.01f * scale * speed);
}

TEST_P(ClothWindTest, AnEdgeOnPlateAndOneWithoutAirFeelNothing) {
  Plate plate(GetParam(), coefficients(1, 0.5f));
  expect_near(plate.force({.velocity = {7, 0, 0}}), {0, 0, 0}, 1e-4f);
  EXPECT_GT(plate.force({.velocity = {0, 7, 0}}).y, 1);
  expect_near(plate.force({.velocity = {0, 7, 0}, .air_density = 0}), {0, 0, 0}, 1e-4f);
}

TEST_P(ClothWindTest, AFreeSheetTakesTheWindsSpeedAndNoMore) {
  for (float density : {0.02f, 0.5f}) {
    World world(weightless(GetParam()));
    ClothDef def = sheet(1, 1, 7, 7);
    def.fabric.density = density;
    const ClothId id = world.create_cloth(def);
    world.set_wind({.velocity = {1, 5, 0}, .air_density = 20});
    float fastest = 0;
    for (int k = 0; k < 200; ++k) {
      world.step(0.02f);
      fastest = std::max(fastest, world.cloth_state(id).momentum.y / world.cloth_state(id).mass);
    }
    EXPECT_NEAR(world.cloth_state(id).momentum.y, 5 * world.cloth_state(id).mass, 0.05f * 5 * density);
    EXPECT_LT(fastest, 5.05f) << density << " kg/m²";
  }
}

// As light as a veil, in a storm, at long steps: the force must not throw it about.
TEST_P(ClothWindTest, AVeilInAStormStaysWithTheStorm) {
  World world(weightless(GetParam()));
  ClothDef def = sheet(1, 1, 9, 9);
  def.fabric.density = 0.01f;
  const ClothId id = world.create_cloth(def);
  world.set_wind({.velocity = {0, 40, 0}, .gust_speed = 5});
  for (int k = 0; k < 60; ++k) {
    world.step(1 / 30.0f);
    for (Vec3 v : world.cloth_velocities(id)) ASSERT_LT(length(v), 90) << "step " << k;
  }
  EXPECT_NEAR(world.cloth_state(id).momentum.y / world.cloth_state(id).mass, 40, 15);
}

// Once the gale has stretched it out. Pushed at once, it locked: edges stayed at more than four lengths.
TEST_P(ClothWindTest, ASheetThatAGaleHasCaughtIsNotLeftStretched) {
  WorldDef in = world_def(GetParam(), 0.1f);
  in.substeps = 4;
  in.iterations = 10;
  World world(in);
  ClothDef def = sheet(0.6f, 0.6f, 21, 21);
  def.fabric.density = 0.2f;
  const ClothId cloth = world.create_cloth(def);
  world.create_attachment(attach(cloth, {0, 10, 20}));
  world.set_wind({.velocity = {-50, 0, 0}});
  run(world, 12, 1.0f / 60);
  for (int k = 0; k < 4; ++k) {
    world.step(1.0f / 60);
    EXPECT_LT(world.cloth_state(cloth).max_stretch, 1.5f);
  }
}

TEST_P(ClothWindTest, AFallingSheetHasATerminalSpeed) {
  World world(world_def(GetParam(), 0.05f));
  ClothDef def = sheet(1, 1, 7, 7);
  def.fabric.bending_stiffness = 10;
  const ClothId id = world.create_cloth(def);
  run(world, 300, 0.01f);
  const float terminal = std::sqrt(2 * 0.2f * 9.81f / (1.2f * def.fabric.drag));
  EXPECT_NEAR(-world.cloth_state(id).momentum.y / world.cloth_state(id).mass, terminal, 0.05f * terminal);
}

TEST_P(ClothWindTest, GustsAreTheSameForTheSameSeedAndGoOnInTime) {
  const auto after = [&](uint32_t seed, int steps) {
    World world(weightless(GetParam()));
    world.create_cloth(sheet(1, 1, 7, 7));
    world.set_wind({.velocity = {0, 2, 0}, .gust_speed = 1, .seed = seed});
    run(world, steps, 0.02f);
    return world.state_hash();
  };
  EXPECT_EQ(after(1, 20), after(1, 20));
  EXPECT_NE(after(1, 20), after(2, 20));
}

// A steady plate feels gusts of the mean strength that they are said to have.
TEST_P(ClothWindTest, GustsHaveTheirStrength) {
  Plate plate(GetParam(), coefficients(1, 0));
  plate.world.set_wind({.velocity = {0, 8, 0}, .gust_speed = 1, .gust_size = 4});
  double sum = 0, squares = 0;
  constexpr int steps = 2000;
  for (int k = 0; k < steps; ++k) {
    plate.world.step(0.02f);
    const double speed = std::sqrt(std::fmax(0, plate.world.attachment_force(plate.held).y / 0.3));
    sum += speed;
    squares += speed * speed;
  }
  const double mean = sum / steps;
  EXPECT_NEAR(mean, 8, 0.4);
  EXPECT_NEAR(std::sqrt(squares / steps - mean * mean), 0.577, 0.25);  // one axis of three
}

MENISCUS_ON_EACH_DEVICE(ClothWindTest);

}  // namespace
}  // namespace meniscus::tests
