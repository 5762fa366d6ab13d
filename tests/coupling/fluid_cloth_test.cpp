// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Fluid and cloth: no particle passes through, forces balance, and momentum is conserved.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/cloth_worlds.h"
#include "tests/coupling/body_worlds.h"
#include "tests/many_threads.h"
#include "tests/sheet_crossings.h"

namespace meniscus::tests {
namespace {

constexpr float side = 0.6f;  // m, of the sheet and the tank around it

/// A sheet pinned at its four borders, walls around it, and water over it.
struct WaterOnSheet {
  World world;
  ClothId cloth;
  AttachmentId pins;
  float mass = 0;  // kg, of all

  WaterOnSheet(const WorldDef& def, float density, int columns, float depth, float gap,
               float stiffness = 1e5f)
      : world(def) {
    const float half = 0.5f * side;
    const FluidId water = world.create_fluid({});
    world.create_shape(tank({-half, -0.5f, -half}, {half, 2, half}));
    ClothDef sheet_def = sheet(side, side, columns, columns);
    sheet_def.fabric.density = density;
    sheet_def.fabric.warp_stiffness = sheet_def.fabric.weft_stiffness = stiffness;
    sheet_def.self_collision = false;
    cloth = world.create_cloth(sheet_def);
    AttachmentDef border = attach(cloth, {});
    for (int row = 0; row < columns; ++row) {
      for (int column = 0; column < columns; ++column) {
        if (row % (columns - 1) == 0 || column % (columns - 1) == 0)
          border.vertices.push_back(static_cast<uint32_t>(row * columns + column));
      }
    }
    pins = world.create_attachment(border);
    const std::size_t count = world.add_fluid(block(water, {-half, gap, -half}, {half, gap + depth, half}));
    mass = static_cast<float>(count) * world.particle_mass(water) + world.cloth_state(cloth).mass;
  }
};

struct LeakCase {
  const char* name;
  float density;       // kg/m²
  int columns;         // of vertices
  int substeps;        // a 60th of a second
  float drop;          // m
  float mean_stretch;  // at most; fine meshes and long substeps still miss the .05 that we aim at
  DensitySolver solver = DensitySolver::chebyshev;
};

class FluidOnCloth : public testing::TestWithParam<std::tuple<pbd::DeviceKind, LeakCase>> {};

/// A particle weighs 0.064 kg: up to 500 times what a vertex does. Every substep is looked at.
TEST_P(FluidOnCloth, DoesNotGoThrough) {
  const auto& [device, c] = GetParam();
  WorldDef def = world_def(device, 0.04f);
  def.substeps = 1;
  def.density.solver = c.solver;
  WaterOnSheet water(def, c.density, c.columns, 0.2f, c.drop);
  SheetCrossings crossings(water.world.cloth_positions(water.cloth),
                           water.world.cloth_triangles(water.cloth));
  size_t crossed = 0;
  for (int k = 0; k < c.substeps * 45; ++k) {
    water.world.step(1 / (60.0f * static_cast<float>(c.substeps)));
    crossed += crossings.advance(water.world.cloth_positions(water.cloth), water.world.positions());
  }
  EXPECT_EQ(crossed, 0u);
  EXPECT_LT(water.world.cloth_state(water.cloth).mean_stretch, c.mean_stretch);
}

INSTANTIATE_TEST_SUITE_P(On, FluidOnCloth,
                         testing::Combine(testing::ValuesIn(usable_devices()),
                                          testing::Values(LeakCase{"Light", 0.2f, 16, 4, 0.03f, 0.05f},
                                                          LeakCase{"Heavy", 40, 16, 4, 0.03f, 0.05f},
                                                          LeakCase{"FineAndLight", 0.2f, 31, 4, 0.03f, 0.1f},
                                                          LeakCase{"Coarse", 0.2f, 5, 4, 0.03f, 0.05f},
                                                          LeakCase{"Falling", 0.2f, 16, 4, 0.4f, 0.05f},
                                                          LeakCase{"LongSubsteps", 0.2f, 16, 1, 0.03f, 0.12f},
                                                          LeakCase{"FineUnderThePressureGrid", 0.2f, 31, 4,
                                                                   0.03f, 0.05f, DensitySolver::grid})),
                         [](const auto& instance) {
                           return std::string(std::get<1>(instance.param).name) + "_" +
                                  testing::PrintToString(std::get<0>(instance.param));
                         });

class FluidAndCloth : public OnDevice {};

TEST_P(FluidAndCloth, RestingWaterHangsFromThePins) {
  for (const auto& [density, solver] : {std::pair{0.2f, DensitySolver::chebyshev},
                                        {40.0f, DensitySolver::chebyshev},
                                        {0.2f, DensitySolver::grid}}) {
    WorldDef def = world_def(GetParam(), 0.05f);
    def.density.solver = solver;
    WaterOnSheet water(def, density, 13, 0.2f, 0.03f);
    run(water.world, 120, 1 / 60.0f);
    double force = 0;
    for (int k = 0; k < 60; ++k) {
      water.world.step(1 / 60.0f);
      force += double{water.world.attachment_force(water.pins).y} / 60;
    }
    EXPECT_NEAR(-force / (9.81 * double{water.mass}), 1, 0.02) << density << " kg/m²";
  }
}

/// Of an edge of half a spacing, where single light vertices hang between those that carry water.
TEST_P(FluidAndCloth, FineLightClothBearsDeepWater) {
  WorldDef def = world_def(GetParam(), 1 / 46.0f);
  def.substeps = 1;
  def.iterations = 4;
  WaterOnSheet water(def, 0.2f, 61, 1.2f, 0.02f, 2e5f);
  SheetCrossings crossings(water.world.cloth_positions(water.cloth),
                           water.world.cloth_triangles(water.cloth));
  size_t crossed = 0;
  for (int k = 0; k < 60; ++k) {
    water.world.step(1 / 240.0f);
    crossed += crossings.advance(water.world.cloth_positions(water.cloth), water.world.positions());
    EXPECT_LT(water.world.cloth_state(water.cloth).mean_stretch, 0.08f) << "after " << k << " substeps";
  }
  EXPECT_EQ(crossed, 0u);
}

/// The effective mass of a vertex is hundreds of times its own. It counts where positions are solved, but not
/// where velocities are. A light vertex leaves a wall at twice the wall's speed at most.
TEST_P(FluidAndCloth, AThrustBetweenVerticesThatBearWaterKicksNone) {
  constexpr float speed = 2.5f, dt = 0.001f;
  WorldDef def = world_def(GetParam(), 0.04f);
  def.substeps = 1;
  WaterOnSheet water(def, 0.2f, 31, 0.2f, 0.03f, 3000);
  run(water.world, 240, dt);
  const auto still = water.world.cloth_positions(water.cloth);
  const float lowest =
      std::min_element(still.begin(), still.end(), [](Vec3 a, Vec3 b) { return a.y < b.y; })->y;
  const Vec3 start{0.01f, lowest - 0.3f, 0.003f};
  const BodyId post = water.world.create_body(kinematic(CapsuleGeometry{0.04f, 0.2f}, start));
  water.world.move_body(post, {start + Vec3{0, 0.2f, 0}}, 0.2f / speed);
  float fastest = 0;
  for (float time = 0; time < 0.2f / speed; time += dt) {
    water.world.step(dt);
    for (Vec3 v : water.world.cloth_velocities(water.cloth)) fastest = std::max(fastest, length(v));
  }
  EXPECT_GT(fastest, speed);  // it has hit
  EXPECT_LT(fastest, 2 * speed);
}

/// Thirty layers deep, with one iteration: what the grid does not carry down to the sheet is missing.
TEST_P(FluidAndCloth, ASheetIsAFloorToThePressureGrid) {
  WorldDef def = world_def(GetParam(), 1 / 30.0f);
  def.density.solver = DensitySolver::grid;
  def.substeps = 4;
  def.iterations = 1;
  WaterOnSheet water(def, 10, 25, 1, 0.03f, 2e5f);
  run(water.world, 60, 1 / 60.0f);
  double error = 0;
  for (int k = 0; k < 20; ++k) {
    water.world.step(1 / 60.0f);
    error += water.world.diagnostics().density_error_mean / 20;
  }
  EXPECT_LT(error, 0.035);
}

TEST_P(FluidAndCloth, KeepTheirMomentum) {
  for (const DensitySolver solver : {DensitySolver::chebyshev, DensitySolver::grid}) {
    WorldDef def = world_def(GetParam(), 0.05f);
    def.gravity = {0, 0, 0};
    def.density.solver = solver;
    World world(def);
    world.set_wind({.air_density = 0});
    const FluidId water = world.create_fluid({});
    ClothDef sheet_def = sheet(0.6f, 0.6f, 13, 13);
    sheet_def.pose.rotation = about_z(10);
    const ClothId cloth = world.create_cloth(sheet_def);
    FluidVolumeDef ball;
    ball.fluid = water;
    ball.region = BallRegion{0.15f};
    ball.pose.position = {0.02f, 0.26f, 0.01f};
    ball.velocity = {0.2f, -2, 0};
    world.add_fluid(ball);
    const double mass = double{world.particle_mass(water)};
    const auto momentum = [&] {
      Sum3 sum = Sum3(world.cloth_state(cloth).momentum);
      for (Vec3 v : world.velocities()) sum += mass * Sum3(v);
      return sum;
    };
    const Sum3 before = momentum();
    double fastest = 0;
    for (int k = 0; k < 30; ++k) {
      world.step(1 / 60.0f);
      EXPECT_LT(norm(momentum() - before), 1e-5 * norm(before)) << "step " << k;
      fastest = std::max(fastest, rms_speed(world, cloth));
    }
    EXPECT_GT(fastest, 0.5) << "they never met";
  }
}

/// A sheet held fast across a tank divides it: it supports the water above, and is not loaded by the water
/// below.
TEST_P(FluidAndCloth, ASheetPartsATank) {
  WorldDef def = world_def(GetParam(), 0.05f);
  World world(def);
  const FluidId water = world.create_fluid({});
  world.create_shape(tank({-0.3f, -0.3f, -0.3f}, {0.3f, 1, 0.3f}));
  const ClothId cloth = world.create_cloth(sheet(0.6f, 0.6f, 13, 13));
  const AttachmentId pins = world.create_attachment(attach(cloth, vertices_from(0, 169)));
  world.add_fluid(block(water, {-0.3f, -0.3f, -0.3f}, {0.3f, 0, 0.3f}));
  world.add_fluid(block(water, {-0.3f, 0, -0.3f}, {0.3f, 0.2f, 0.3f}));
  EXPECT_EQ(world.particle_count(), 12u * 12 * 10);
  run(world, 90, 1 / 60.0f);
  const Diagnostics d = world.diagnostics();
  EXPECT_LT(d.density_error_mean, 0.005f);
  EXPECT_LT(d.max_speed, 0.3f);
  double load = 0;
  for (int k = 0; k < 30; ++k) {
    world.step(1 / 60.0f);
    load += double{world.attachment_force(pins).y} / 30;
  }
  const double weight_above = 9.81 * 12 * 12 * 4 * double{world.particle_mass(water)};
  EXPECT_NEAR(-load / weight_above, 1, 0.02);
  size_t above = 0;
  for (Vec3 p : world.positions()) above += p.y > 0;
  EXPECT_EQ(above, 12u * 12 * 4);
}

TEST_P(FluidAndCloth, SeedingKeepsOffCloth) {
  World world(world_def(GetParam(), 0.05f));
  const FluidId water = world.create_fluid({});
  world.create_cloth(sheet(0.6f, 0.6f, 13, 13, {0, 0.01f, 0}));
  world.add_fluid(block(water, {-0.2f, -0.2f, -0.2f}, {0.2f, 0.2f, 0.2f}));
  EXPECT_EQ(world.particle_count(), 8u * 8 * 7);  // a layer would be at 0.025 m
}

TEST_P(FluidAndCloth, FiltersLetItThrough) {
  WorldDef def = world_def(GetParam(), 0.05f);
  World world(def);
  FluidDef water_def;
  water_def.filter = {1, 1};
  const FluidId water = world.create_fluid(water_def);
  ClothDef net = sheet(0.6f, 0.6f, 13, 13);
  net.filter = {2, 2};
  const ClothId cloth = world.create_cloth(net);
  world.create_attachment(attach(cloth, vertices_from(0, 169)));
  world.add_fluid(block(water, {-0.1f, 0.05f, -0.1f}, {0.1f, 0.25f, 0.1f}));
  World bare(def);
  bare.add_fluid(block(bare.create_fluid(water_def), {-0.1f, 0.05f, -0.1f}, {0.1f, 0.25f, 0.1f}));
  for (int k = 0; k < 40; ++k) {
    world.step(1 / 60.0f);
    bare.step(1 / 60.0f);
  }
  for (size_t i = 0; i < world.particle_count(); ++i)
    EXPECT_LT(length(world.positions()[i] - bare.positions()[i]), 1e-5f) << "as if there were no cloth";
}

TEST_P(FluidAndCloth, ContactsNameTheCloth) {
  WaterOnSheet water(world_def(GetParam(), 0.05f), 0.2f, 13, 0.1f, 0.03f);
  run(water.world, 30, 1 / 60.0f);
  size_t on_cloth = 0;
  double pull = 0;
  for (const ParticleContact& c : water.world.particle_contacts()) {
    if (c.cloth != water.cloth) continue;
    ++on_cloth;
    pull += double{c.impulse.y};
  }
  EXPECT_GT(on_cloth, 50u);
  EXPECT_GT(pull, 0);
  water.world.destroy_cloth(water.cloth);
  for (const ParticleContact& c : water.world.particle_contacts()) EXPECT_NE(c.cloth, water.cloth);
  run(water.world, 30, 1 / 60.0f);
  EXPECT_LT(mean_height(water.world), -0.1) << "the water falls when the sheet is gone";
}

// Not after its number, which another sheet has when one before it is gone.
TEST_P(FluidAndCloth, ContactsNameTheClothThatTheyWereWith) {
  World world(world_def(GetParam(), 0.05f));
  const ClothId gone = world.create_cloth(sheet(0.5f, 0.5f, 9, 9, {3, 0, 0}));
  const ClothId wet = world.create_cloth(sheet(0.5f, 0.5f, 9, 9));
  world.create_cloth(sheet(0.5f, 0.5f, 9, 9, {-3, 0, 0}));
  world.create_attachment(attach(wet, vertices_from(0, 81)));
  world.add_fluid(block(world.create_fluid({}), {-0.15f, 0.03f, -0.15f}, {0.15f, 0.13f, 0.15f}));
  run(world, 10, 1 / 60.0f);
  const size_t contacts = world.particle_contacts().size();
  ASSERT_GT(contacts, 10u);
  world.destroy_cloth(gone);
  world.diagnostics();  // for which cloth is uploaded
  const std::vector<ParticleContact> found = world.particle_contacts();
  EXPECT_EQ(found.size(), contacts);
  for (const ParticleContact& c : found) EXPECT_EQ(c.cloth, wet);
}

TEST_P(FluidAndCloth, AreTheSameEachTime) {
  const auto hash = [&](int threads) {
    WorldDef def = world_def(GetParam(), 0.05f);
    def.threads = threads;
    WaterOnSheet water(def, 0.2f, 17, 0.15f, 0.03f);
    BodyDef ball = body(SphereGeometry{0.08f}, {0.02f, 0.4f, 0}, 400);
    water.world.create_body(ball);
    run(water.world, 30, 1 / 60.0f);
    return water.world.state_hash();
  };
  const uint64_t first = hash(1);
  EXPECT_EQ(hash(1), first);
  if (GetParam() == pbd::DeviceKind::cpu) {
    const ManyThreads allowed;
    EXPECT_EQ(hash(3), first);
  }
}

TEST_P(FluidAndCloth, ADropSticksWithAdhesion) {
  const auto lowest_after = [&](float adhesion) {
    WorldDef def = world_def(GetParam(), 0.02f);
    World world(def);
    FluidDef water_def;
    water_def.surface_tension = 0.5f;
    const FluidId water = world.create_fluid(water_def);
    ClothDef ceiling = sheet(0.3f, 0.3f, 16, 16);
    ceiling.fabric.fluid_adhesion = adhesion;
    const ClothId cloth = world.create_cloth(ceiling);
    world.create_attachment(attach(cloth, vertices_from(0, 256)));
    world.add_fluid(block(water, {-0.04f, -0.021f, -0.04f}, {0.04f, -0.0005f, 0.04f}));
    run(world, 30, 1 / 60.0f);
    return mean_height(world);
  };
  EXPECT_LT(lowest_after(0), -0.5);
  EXPECT_GT(lowest_after(2000), -0.03);
}

MENISCUS_ON_EACH_DEVICE(FluidAndCloth);

}  // namespace
}  // namespace meniscus::tests
