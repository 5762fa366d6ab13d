// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cloth that takes up water, grows heavy by it, and drips.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/cloth_worlds.h"
#include "tests/coupling/body_worlds.h"
#include "tests/expect_error.h"
#include "tests/many_threads.h"

namespace meniscus::tests {
namespace {

constexpr float spacing = 0.02f, size = 0.4f;  // m
constexpr int across = 17;                     // vertices

/// Terry: a particle of 8 g wets 40 cm² of it.
ClothDef towel(Vec3 position) {
  ClothDef def = sheet(size, size, across, across, position);
  def.fabric.density = 0.4f;
  def.fabric.absorbency = 2;
  return def;
}

std::vector<uint32_t> first_row() {
  return vertices_from(0, across);
}

std::vector<uint32_t> border() {
  std::vector<uint32_t> chosen;
  for (uint32_t v = 0; v < across * across; ++v) {
    if (v / across % (across - 1) == 0 || v % across % (across - 1) == 0) chosen.push_back(v);
  }
  return chosen;
}

class WetCloth : public OnDevice {
 protected:
  /// kg, of particles and in the cloth.
  static double mass(const World& world, FluidId water, ClothId cloth) {
    return static_cast<double>(world.particle_count()) * double{world.particle_mass(water)} +
           double{world.cloth_state(cloth).fluid_mass};
  }
  static double capacity(const World& world, ClothId cloth, const ClothDef& def) {
    return double{world.cloth_state(cloth).area * def.fabric.absorbency};
  }
};

TEST_P(WetCloth, TakesUpWhatItHoldsAndNoMore) {
  World world(world_def(GetParam(), spacing));
  const FluidId water = world.create_fluid({});
  ClothDef def = towel({0, 0, 0});
  def.fabric.retention = 1;
  def.fabric.drainage = 0;
  const ClothId cloth = world.create_cloth(def);
  world.create_attachment(attach(cloth, border()));
  world.create_shape(tank({-0.2f, -1, -0.2f}, {0.2f, 1, 0.2f}));
  world.add_fluid(block(water, {-0.2f, 0.02f, -0.2f}, {0.2f, 0.06f, 0.2f}));
  const double before = mass(world, water, cloth);
  uint32_t absorbed = 0;
  for (int k = 0; k < 60; ++k) {
    absorbed += world.step(1 / 60.0f).absorbed;
    EXPECT_NEAR(mass(world, water, cloth), before, 1e-6 * before) << "step " << k;
  }
  const double held = double{world.cloth_state(cloth).fluid_mass}, most = capacity(world, cloth, def);
  EXPECT_EQ(world.particle_count() + absorbed, 800u);
  EXPECT_NEAR(held, absorbed * double{world.particle_mass(water)}, 1e-6 * held);
  EXPECT_LE(held, (1 + 1e-6) * most);
  EXPECT_GT(held, 0.9 * most);
  for (const float wetness : world.cloth_wetness(cloth)) EXPECT_LE(wetness, 1 + 1e-5f);
  EXPECT_NEAR(double{world.cloth_state(cloth).mass}, held + double{0.4f * world.cloth_state(cloth).area},
              1e-4);
}

TEST_P(WetCloth, DryClothTakesNone) {
  World world(world_def(GetParam(), spacing));
  const FluidId water = world.create_fluid({});
  ClothDef def = towel({0, 0, 0});
  def.fabric.absorbency = 0;
  const ClothId cloth = world.create_cloth(def);
  world.create_attachment(attach(cloth, border()));
  world.add_fluid(block(water, {-0.1f, 0.02f, -0.1f}, {0.1f, 0.06f, 0.1f}));
  for (int k = 0; k < 20; ++k) EXPECT_EQ(world.step(1 / 60.0f).absorbed, 0u);
  for (const float wetness : world.cloth_wetness(cloth)) EXPECT_EQ(wetness, 0);
}

TEST_P(WetCloth, KeepsTheMomentumOfWhatItTakesUp) {
  WorldDef def = world_def(GetParam(), spacing);
  def.gravity = {0, 0, 0};
  World world(def);
  world.set_wind({.air_density = 0});
  const FluidId water = world.create_fluid({});
  const ClothId cloth = world.create_cloth(towel({0, 0, 0}));
  FluidVolumeDef ball;
  ball.fluid = water;
  ball.region = BallRegion{0.06f};
  ball.pose.position = {0.02f, 0.09f, 0.01f};
  ball.velocity = {0.2f, -2, 0};
  world.add_fluid(ball);
  const auto momentum = [&] {
    return fluid_momentum(world, water).linear + Sum3(world.cloth_state(cloth).momentum);
  };
  const Sum3 before = momentum();
  uint32_t absorbed = 0;
  for (int k = 0; k < 30; ++k) {
    absorbed += world.step(1 / 60.0f).absorbed;
    EXPECT_LT(norm(momentum() - before), 1e-5 * norm(before)) << "step " << k;
  }
  EXPECT_GT(absorbed, 10u);
}

/// Dipped and hung up, it is as heavy as it and its water, and drips until it holds what it keeps.
TEST_P(WetCloth, HungUpItDripsAndIsHeavierByWhatItKeeps) {
  WorldDef world_of = world_def(GetParam(), spacing);
  World world(world_of);
  const FluidId water = world.create_fluid({});
  ClothDef def = towel({0, 0, 0});
  def.fabric.retention = 0.5f;
  def.fabric.drainage = 0.5f;
  const ClothId cloth = world.create_cloth(def);
  const AttachmentId line = world.create_attachment(attach(cloth, first_row()));
  const AttachmentId other =
      world.create_attachment(attach(cloth, vertices_from(across * (across - 1), across)));
  world.add_fluid(block(water, {-0.16f, 0.02f, -0.16f}, {0.16f, 0.06f, 0.16f}));
  run(world, 20, 1 / 60.0f);
  const double soaked = double{world.cloth_state(cloth).fluid_mass};
  world.destroy_attachment(other);
  std::vector<ParticleId> rest(world.ids().begin(), world.ids().end());
  world.remove_particles(rest);
  uint32_t dripped = 0, taken_back = 0;
  float lowest = 0;
  for (Vec3 x : world.cloth_positions(cloth)) lowest = std::min(lowest, x.y);
  for (int k = 0; k < 240; ++k) {
    const StepReport report = world.step(1 / 60.0f);
    dripped += report.dripped;
    taken_back += report.absorbed;
    EXPECT_NEAR(mass(world, water, cloth), soaked, 1e-6 * soaked) << "step " << k;
  }
  const ClothState state = world.cloth_state(cloth);
  const double kept = 0.5 * capacity(world, cloth, def), drop = double{world.particle_mass(water)};
  EXPECT_GT(soaked, 1.2 * kept);
  EXPECT_LT(double{state.fluid_mass}, kept + 3 * drop);
  EXPECT_GT(double{state.fluid_mass}, 0.9 * kept);
  EXPECT_EQ(world.particle_count(), dripped - taken_back);
  EXPECT_LT(mean_height(world), -0.4) << "what drips falls";
  double force = 0;
  for (int k = 0; k < 60; ++k) {
    world.step(1 / 60.0f);
    force += double{world.attachment_force(line).y} / 60;
  }
  EXPECT_NEAR(-force / (9.81 * double{world.cloth_state(cloth).mass}), 1, 0.02);
}

TEST_P(WetCloth, IsTheSameEachTime) {
  const auto state = [&](int threads) {
    WorldDef def = world_def(GetParam(), spacing);
    def.threads = threads;
    World world(def);
    const FluidId water = world.create_fluid({});
    const ClothId cloth = world.create_cloth(towel({0, 0, 0}));
    world.create_attachment(attach(cloth, first_row()));
    world.add_fluid(block(water, {-0.1f, 0.02f, -0.1f}, {0.1f, 0.1f, 0.1f}));
    run(world, 30, 1 / 60.0f);
    EXPECT_GT(world.cloth_state(cloth).fluid_mass, 0);
    const auto wetness = world.cloth_wetness(cloth);
    return std::pair(world.state_hash(), std::vector<float>(wetness.begin(), wetness.end()));
  };
  const auto first = state(1);
  EXPECT_EQ(state(1), first);
  if (GetParam() == pbd::DeviceKind::cpu) {
    const ManyThreads allowed;
    EXPECT_EQ(state(3), first);
  }
}

TEST_P(WetCloth, TornItLosesNone) {
  WorldDef def = world_def(GetParam(), spacing);
  World world(def);
  const FluidId water = world.create_fluid({});
  ClothDef rag = towel({0, 0, 0});
  rag.fabric.tear_strain = 0.05f;
  rag.fabric.warp_stiffness = rag.fabric.weft_stiffness = 100;
  rag.fabric.retention = 1;
  rag.tethers = false;
  const ClothId cloth = world.create_cloth(rag);
  world.create_attachment(attach(cloth, border()));
  world.add_fluid(block(water, {-0.12f, 0.02f, -0.12f}, {0.12f, 0.1f, 0.12f}));
  const double before = mass(world, water, cloth);
  size_t tears = 0;
  for (int k = 0; k < 40; ++k) {
    world.step(1 / 60.0f);
    tears += world.tear_events().size();
    EXPECT_NEAR(mass(world, water, cloth), before, 1e-6 * before) << "step " << k;
  }
  EXPECT_GT(tears, 0u);
  EXPECT_GT(world.cloth_state(cloth).fluid_mass, 0);
  EXPECT_EQ(world.cloth_wetness(cloth).size(), world.cloth_positions(cloth).size());
}

TEST_P(WetCloth, TornItTakesUpOnlyWhatTouchesIt) {
  World world(world_def(GetParam(), spacing));
  const FluidId water = world.create_fluid({});
  ClothDef rag = towel({5, 0, 0});
  rag.stretch = {1.8f, 1, 1};
  rag.fabric.tear_strain = 0.5f;
  const ClothId torn = world.create_cloth(rag), wet = world.create_cloth(towel({0, 0, 0}));
  for (const ClothId cloth : {torn, wet}) world.create_attachment(attach(cloth, border()));
  // On its first rows: the numbers that follow those of the piece before, which gets more of them.
  world.add_fluid(block(water, {-0.18f, 0, -0.2f}, {0.18f, 0.02f, -0.14f}));
  size_t tears = 0;
  for (int k = 0; k < 6; ++k) {
    world.step(1 / 120.0f);
    tears += world.tear_events().size();
  }
  EXPECT_GT(tears, 0u);
  EXPECT_EQ(world.cloth_state(torn).fluid_mass, 0);
  EXPECT_GT(world.cloth_state(wet).fluid_mass, 0);
}

TEST_P(WetCloth, WaterRunsDownWhereNoFluidMeetsIt) {
  World world(world_def(GetParam(), spacing));
  FluidDef def;
  const FluidId water = world.create_fluid(def);
  ClothDef rag = towel({0, 0, 0});
  rag.fabric.retention = 0;
  rag.pose.rotation = about_z(30);
  const ClothId cloth = world.create_cloth(rag);
  world.create_attachment(attach(cloth, border()));
  world.add_fluid(block(water, {-0.1f, 0, -0.1f}, {0.1f, 0.02f, 0.1f}));
  run(world, 6, 1 / 120.0f);
  EXPECT_GT(world.cloth_state(cloth).fluid_mass, 0);
  const auto wetness = [&] {
    const auto now = world.cloth_wetness(cloth);
    return std::vector<float>(now.begin(), now.end());
  };
  const std::vector<float> before = wetness();
  def.filter.mask = 0;
  world.set_fluid(water, def);
  run(world, 10, 1 / 60.0f);
  EXPECT_NE(wetness(), before);
}

TEST_P(WetCloth, WrongValuesAreNamed) {
  World world(world_def(GetParam(), spacing));
  const auto refused = [&](const char* name, auto member, float value) {
    ClothDef def = towel({0, 0, 0});
    def.fabric.*member = value;
    expect_error(ErrorCode::invalid_argument, name, [&] { world.create_cloth(def); });
  };
  refused("FabricDef::permittivity", &FabricDef::permittivity, -1.0f);
  refused("FabricDef::absorbency", &FabricDef::absorbency, -1.0f);
  refused("FabricDef::retention", &FabricDef::retention, 1.5f);
  refused("FabricDef::drainage", &FabricDef::drainage, -0.1f);
}

MENISCUS_ON_EACH_DEVICE(WetCloth);

}  // namespace
}  // namespace meniscus::tests
