// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What exceeds a fixed size of cloth and of the fluid near it is counted or refused.
#include <gtest/gtest.h>

#include "tests/cloth_worlds.h"
#include "tests/expect_error.h"

namespace meniscus::tests {
namespace {

class ClothOverflows : public OnDevice {
 protected:
  static constexpr float spacing = 0.05f;

  static WorldDef weightless(pbd::DeviceKind device) {
    WorldDef def = world_def(device, spacing);
    def.gravity = {0, 0, 0};
    return def;
  }
  static ClothId pinned(World& world, const ClothDef& def) {
    const ClothId cloth = world.create_cloth(def);
    const auto vertices = static_cast<uint32_t>(world.cloth_positions(cloth).size());
    world.create_attachment(attach(cloth, vertices_from(0, vertices)));
    return cloth;
  }
  static Overflows after_a_step(World& world) { return world.step(0.001f).overflows; }
};

/// Sheets around a particle, each 0.03 m from it.
World in_a_box_of_cloth(const WorldDef& def, const std::vector<Vec3>& sides) {
  World world(def);
  for (const Vec3 side : sides) {
    ClothDef wall = sheet(0.4f, 0.4f, 9, 9, 0.03f * side);
    const float half = 0.70710678f;
    if (side.x != 0) wall.pose.rotation = {0, 0, half, half};
    if (side.z != 0) wall.pose.rotation = {half, 0, 0, half};
    wall.self_collision = false;
    wall.filter = {2, 1};
    const ClothId cloth = world.create_cloth(wall);
    world.create_attachment(attach(cloth, vertices_from(0, 81)));
  }
  const FluidId water = world.create_fluid({});
  const Vec3 middle[] = {{0, 0, 0}};
  world.add_particles(water, middle);
  return world;
}

TEST_P(ClothOverflows, CountParticlesNearManyLayers) {
  const std::vector<Vec3> sides{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}};
  World three = in_a_box_of_cloth(weightless(GetParam()), {sides.begin(), sides.begin() + 3});
  EXPECT_EQ(after_a_step(three).cloth_layers, 0u);
  World five = in_a_box_of_cloth(weightless(GetParam()), sides);
  EXPECT_EQ(after_a_step(five).cloth_layers, static_cast<uint32_t>(WorldDef{}.substeps));
}

/// Of long thin triangles, whose mean edge tells little of how many vertices are near.
TEST_P(ClothOverflows, CountContactsOfManyVertices) {
  for (const bool fine : {false, true}) {
    World world(weightless(GetParam()));
    const int columns = fine ? 13 : 25, rows = fine ? 241 : 25;
    pinned(world, sheet(0.6f, 0.6f, columns, rows));
    const FluidId water = world.create_fluid({});
    const Vec3 above[] = {{0.025f, 0.02f, 0.001f}};
    world.add_particles(water, above);
    EXPECT_EQ(after_a_step(world).cloth_vertices > 0, fine);
  }
}

/// Two sheets that ignore one another pass through one another in a step, with a particle between.
TEST_P(ClothOverflows, CountParticlesThatNothingStops) {
  for (const bool from_both_sides : {false, true}) {
    WorldDef def = weightless(GetParam());
    def.substeps = 1;
    World world(def);
    for (const float side : {-1.0f, 1.0f}) {
      if (side < 0 && !from_both_sides) continue;
      ClothDef heavy = sheet(0.4f, 0.4f, 9, 9, {0, 0.04f * side, 0});
      heavy.fabric.density = 1e4f;
      heavy.self_collision = false;
      heavy.filter = {2, 1};
      heavy.velocity = {0, -10 * side, 0};
      world.create_cloth(heavy);
    }
    const FluidId water = world.create_fluid({});
    const Vec3 middle[] = {{0.01f, 0, 0.003f}};
    world.add_particles(water, middle);
    EXPECT_EQ(world.step(0.01f).overflows.fluid_failsafe, from_both_sides ? 1u : 0u);
  }
}

TEST_P(ClothOverflows, RefuseMorePiecesThanVerticesCanName) {
  World world(world_def(GetParam(), spacing));
  const RopeDef def = rope({{0, 0, 0}, {1, 0, 0}}, 1);
  RopeId last{};
  for (int k = 0; k < 65536; ++k) last = world.create_rope(def);
  expect_error(ErrorCode::capacity, "65536 pieces", [&] { world.create_rope(def); });
  expect_error(ErrorCode::capacity, "65536 pieces", [&] { world.create_cloth(sheet(1, 1, 3, 3)); });
  world.destroy_rope(last);
  world.create_cloth(sheet(1, 1, 3, 3));
}

MENISCUS_ON_EACH_DEVICE(ClothOverflows);

}  // namespace
}  // namespace meniscus::tests
