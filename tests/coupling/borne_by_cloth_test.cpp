// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cloth that supports a body and gets wet: a hammock, and a parachute in rain.
#include <gtest/gtest.h>

#include <random>

#include "tests/cloth_worlds.h"
#include "tests/coupling/body_worlds.h"
#include "tests/sheet_crossings.h"

namespace meniscus::tests {
namespace {

constexpr float dt = 1 / 60.0f, gravity = 9.81f;

class BorneByCloth : public OnDevice {
 protected:
  World world_of(float spacing) {
    WorldDef def = world_def(GetParam(), spacing);
    def.substeps = 8;
    def.iterations = 4;
    return World(def);
  }

  /// Steps on; how many particles have passed through the cloth.
  static size_t crossings(World& world, ClothId cloth, int steps) {
    SheetCrossings counter(world.cloth_positions(cloth), world.cloth_triangles(cloth));
    counter.advance(world.cloth_positions(cloth), world.positions());
    size_t crossed = 0;
    for (int k = 0; k < steps; ++k) {
      world.step(dt);
      crossed += counter.advance(world.cloth_positions(cloth), world.positions());
    }
    return crossed;
  }

  static bool touches(const World& world, ClothId cloth) {
    for (const ParticleContact& c : world.particle_contacts()) {
      if (c.cloth == cloth) return true;
    }
    return false;
  }
};

// Canvas of 1 kg, held at its ends, supports a log of 13 kg and water that is poured over it.
TEST_P(BorneByCloth, AHammock) {
  World world = world_of(0.03f);
  ClothDef canvas = sheet(2.1f, 1.2f, 36, 21);
  canvas.stretch = {0.9f, 1, 0.66f};
  canvas.fabric.density = 0.4f;
  canvas.fabric.warp_stiffness = canvas.fabric.weft_stiffness = 20000;
  canvas.fabric.stretch_damping = 0.02f;
  const ClothId cloth = world.create_cloth(canvas);
  AttachmentDef ends = attach(cloth, {});
  for (uint32_t row = 0; row < 21; ++row) {
    ends.vertices.push_back(36 * row);
    ends.vertices.push_back(36 * row + 35);
  }
  const AttachmentId pins = world.create_attachment(ends);
  BodyDef log_def = body(CapsuleGeometry{0.09f, 0.45f}, {0, 0.11f, 0}, 500);
  log_def.pose.rotation = about_z(90);
  log_def.angular_damping = 0.3f;
  log_def.surface.friction = 0.6f;
  const BodyId log = world.create_body(log_def);
  run(world, 90, dt);
  const FluidId water = world.create_fluid({});
  const FluidVolumeDef pail = block(water, {-0.15f, 0.1f, -0.06f}, {0.15f, 0.22f, 0.06f});
  ASSERT_GT(world.add_fluid(pail), 100u);
  EXPECT_EQ(crossings(world, cloth, 90), 0u);
  EXPECT_TRUE(touches(world, cloth));
  EXPECT_GT(world.body_state(log).pose.position.y, -0.7f);
  EXPECT_LT(world.cloth_state(cloth).mean_stretch, 0.04f);
  float caught = 0;
  for (Vec3 x : world.positions()) caught += x.y > -0.7f ? static_cast<float>(world.particle_mass(water)) : 0;
  EXPECT_GT(caught, 3);
  const float weight = gravity * (world.body_mass(log).mass + world.cloth_state(cloth).mass + caught);
  float borne = 0;
  for (int k = 0; k < 60; ++k) {
    world.step(dt);
    borne -= world.attachment_force(pins).y / 60;
  }
  EXPECT_NEAR(borne, weight, 0.03f * weight);
}

// Drag in proportion to the square of the speed supports 4 kg, and the rain on the canopy.
TEST_P(BorneByCloth, AParachuteInRain) {
  World world = world_of(0.03f);
  constexpr float size = 1.6f, length_of_lines = 1, mass = 4;
  ClothDef canopy = sheet(size, size, 17, 17);
  canopy.fabric.density = 0.1f;
  const ClothId cloth = world.create_cloth(canopy);
  BodyDef load = body(BoxGeometry{{size / 2, 0.02f, size / 2}}, {0, -length_of_lines - 0.02f, 0}, 500);
  load.mass = mass;
  const BodyId frame = world.create_body(load);
  for (uint32_t vertex : {0u, 8u, 16u, 136u, 152u, 272u, 280u, 288u}) {
    const Vec3 top = world.cloth_positions(cloth)[vertex];
    RopeDef def = rope({top, top - Vec3{0, length_of_lines, 0}}, 8);
    def.density = 900;
    def.filter = {0, 0};
    const RopeId line = world.create_rope(def);
    AttachmentDef upper = attach(line, {0}), lower = attach(line, {8});
    upper.other_cloth = cloth;
    lower.body = frame;
    world.create_attachment(upper);
    world.create_attachment(lower);
  }
  std::mt19937 random(1);
  std::vector<Vec3> drops;
  for (int k = 0; k < 120; ++k)
    drops.push_back(random_vector(random, 0.6f) + Vec3{0, 0.8f + 0.02f * static_cast<float>(k), 0});
  const FluidId water = world.create_fluid({});
  world.add_particles(water, drops, std::vector<Vec3>(drops.size(), Vec3{0, -3, 0}));
  EXPECT_EQ(crossings(world, cloth, 90), 0u);
  EXPECT_TRUE(touches(world, cloth));
  const float fabric_mass = world.cloth_state(cloth).mass, area = size * size;
  const auto terminal = [&](float m) {
    return std::sqrt(2 * m * gravity / (1.2f * canopy.fabric.drag * area));
  };
  const float speed = -world.body_state(frame).velocity.y;
  const float rain = 120 * static_cast<float>(world.particle_mass(water));
  EXPECT_GT(speed, 0.8f * terminal(mass + fabric_mass));
  EXPECT_LT(speed, 1.3f * terminal(mass + fabric_mass + rain));
}

MENISCUS_ON_EACH_DEVICE(BorneByCloth);

}  // namespace
}  // namespace meniscus::tests
