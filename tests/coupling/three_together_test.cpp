// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Fluid, cloth and bodies that all touch each other: their exchange of momentum balances.
#include <gtest/gtest.h>

#include "tests/cloth_worlds.h"
#include "tests/coupling/body_worlds.h"
#include "tests/many_threads.h"
#include "tests/rigid_solvers.h"

namespace meniscus::tests {
namespace {

/// Which objects touched each other in a step.
struct Touching {
  bool fluid_cloth = false, fluid_body = false, cloth_body = false;
};

/// A free sheet between a ball of water from above and one of stone from below, which meet through it, while
/// a second stone is struck by the water itself.
struct Collision {
  World world;
  FluidId water;
  ClothId cloth;
  BodyId lower, upper;
  Touching seen;

  explicit Collision(const WorldDef& def, bool self_collision = true, const FluidDef& fluid = {})
      : world(def) {
    world.set_wind({.air_density = 0});
    water = world.create_fluid(fluid);
    ClothDef sheet_def = sheet(0.7f, 0.7f, 15, 15);
    sheet_def.pose.rotation = about_z(10);
    sheet_def.self_collision = self_collision;
    cloth = world.create_cloth(sheet_def);
    BodyDef stone = body(SphereGeometry{0.08f}, {0.03f, -0.2f, 0.02f}, 800);
    stone.velocity = {0, 1.5f, 0.1f};
    stone.angular_velocity = {0, 0, 3};
    lower = world.create_body(stone);
    stone = body(SphereGeometry{0.08f}, {-0.05f, 0.55f, 0}, 1500);
    stone.velocity = {0, -3, 0};
    upper = world.create_body(stone);
    FluidVolumeDef ball;
    ball.fluid = water;
    ball.region = BallRegion{0.17f};
    ball.pose.position = {0.02f, 0.27f, 0.01f};
    ball.velocity = {0.2f, -2, 0};
    world.add_fluid(ball);
  }

  void step(float dt) {
    world.step(dt);
    for (const ParticleContact& c : world.particle_contacts()) {
      seen.fluid_cloth |= c.cloth == cloth;
      seen.fluid_body |= c.body == lower || c.body == upper;
    }
    // What moves the lower stone is the cloth: no water is beneath it.
    seen.cloth_body |= norm(world.body_state(lower).fluid_force) > 0;
  }

  Momentum momentum() const {
    return cloth_momentum(world, cloth) + fluid_momentum(world, water) + body_momentum(world, lower) +
           body_momentum(world, upper);
  }
};

class ThreeTogether : public WithSolver {
 protected:
  static WorldDef weightless(float spacing) {
    WorldDef def = world_def(GetParam(), spacing);
    def.gravity = {0, 0, 0};
    return def;
  }

  static void expect_kept(const std::string& what, const WorldDef& def, const FluidDef& fluid,
                          bool self_collision = true) {
    SCOPED_TRACE(what);
    Collision all(def, self_collision, fluid);
    const Momentum before = all.momentum();
    double linear = 0;
    for (int k = 0; k < 40; ++k) {
      all.step(1 / 60.0f);
      linear = std::max(linear, norm(all.momentum().linear - before.linear) / before.gross);
    }
    RecordProperty("linear_drift_" + what, std::to_string(1e6 * linear) + "e-6");
    EXPECT_LT(linear, 1e-5);
    EXPECT_TRUE(all.seen.fluid_cloth && all.seen.fluid_body && all.seen.cloth_body) << "they never met";
  }
};

TEST_P(ThreeTogether, KeepTheirMomentum) {
  expect_kept("plain", weightless(0.05f), {});
  expect_kept("without_self_collision", weightless(0.05f), {}, false);
}

TEST_P(ThreeTogether, KeepTheirMomentumWithForcesBetweenParticles) {
  FluidDef tense, sticky, thick;
  tense.surface_tension = 50;
  sticky.cohesion = 50;
  thick.dynamic_viscosity = 50;
  expect_kept("surface_tension", weightless(0.05f), tense);
  expect_kept("cohesion", weightless(0.05f), sticky);
  expect_kept("viscosity", weightless(0.05f), thick);
}

TEST_P(ThreeTogether, KeepTheirMomentumWithEachSolver) {
  for (DensitySolver solver : {DensitySolver::jacobi, DensitySolver::grid}) {
    WorldDef def = weightless(0.05f);
    def.density.solver = solver;
    expect_kept(solver == DensitySolver::grid ? "grid" : "jacobi", def, {});
  }
}

/// A sheet whose border is attached to a heavy frame stops a ball of water.
TEST_P(ThreeTogether, TiedToABodyClothHandsOnWhatWaterPushes) {
  World world(weightless(0.05f));
  world.set_wind({.air_density = 0});
  const FluidId water = world.create_fluid({});
  const ClothId cloth = world.create_cloth(sheet(0.6f, 0.6f, 13, 13));
  BodyDef frame = body(BoxGeometry{{0.3f, 0.02f, 0.02f}}, {0, 0, -0.3f}, 20000);
  frame.filter = {2, 0};
  const BodyId bar = world.create_body(frame);
  AttachmentDef border = attach(cloth, {});
  for (uint32_t v = 0; v < 169; ++v) {
    if (v / 13 % 12 == 0 || v % 13 % 12 == 0) border.vertices.push_back(v);
  }
  border.body = bar;
  world.create_attachment(border);
  FluidVolumeDef ball;
  ball.fluid = water;
  ball.region = BallRegion{0.17f};
  ball.pose.position = {0.02f, 0.24f, 0.01f};
  ball.velocity = {0.2f, -2, 0};
  world.add_fluid(ball);
  const auto momentum = [&] {
    return cloth_momentum(world, cloth) + fluid_momentum(world, water) + body_momentum(world, bar);
  };
  const Momentum before = momentum();
  double linear = 0;
  float stretch = 0;
  for (int k = 0; k < 40; ++k) {
    world.step(1 / 60.0f);
    const Momentum now = momentum();
    linear = std::max(linear, norm(now.linear - before.linear) / before.gross);
    stretch = std::max(stretch, world.cloth_state(cloth).max_stretch);
  }
  RecordProperty("linear_drift", std::to_string(1e6 * linear) + "e-6");
  EXPECT_LT(linear, 1e-5);
  EXPECT_LT(stretch, 1.1f);
  EXPECT_LT(body_momentum(world, bar).linear.y, -1) << "they never met";
}

TEST_P(ThreeTogether, AreTheSameEachTime) {
  const auto hash = [&](int threads) {
    WorldDef def = world_def(GetParam(), 0.05f);
    def.threads = threads;
    Collision all(def);
    for (int k = 0; k < 20; ++k) all.step(1 / 60.0f);
    EXPECT_TRUE(all.seen.fluid_cloth && all.seen.fluid_body && all.seen.cloth_body) << "they never met";
    return all.world.state_hash();
  };
  const uint64_t first = hash(1);
  EXPECT_EQ(hash(1), first);
  if (GetParam().device == pbd::DeviceKind::cpu) {
    const ManyThreads allowed;
    for (int threads : {2, 3, 8}) EXPECT_EQ(hash(threads), first) << threads << " threads";
  }
}

/// Water in a sheet that hangs from its border, and a block that floats in the water. At rest, the forces on
/// each part must balance: the pins support everything, and the block and the water each receive a force
/// equal to their weight.
TEST_P(ThreeTogether, HangingAtRestEachBearsItsWeight) {
  WorldDef def = world_def(GetParam(), 0.05f);
  def.substeps = 1;  // so that each contact can be read
  World world(def);
  constexpr float half = 0.3f, dt = 1 / 240.0f;
  world.create_shape(tank({-half, -0.5f, -half}, {half, 2, half}));
  ClothDef sheet_def = sheet(2 * half, 2 * half, 13, 13);
  sheet_def.fabric.warp_stiffness = sheet_def.fabric.weft_stiffness = 1e5f;
  const ClothId cloth = world.create_cloth(sheet_def);
  AttachmentDef border = attach(cloth, {});
  for (uint32_t v = 0; v < 169; ++v) {
    if (v / 13 % 12 == 0 || v % 13 % 12 == 0) border.vertices.push_back(v);
  }
  const AttachmentId pins = world.create_attachment(border);
  BodyDef block_def = body(BoxGeometry{{0.1f, 0.06f, 0.1f}}, {0, 0.15f, 0}, 500);
  block_def.can_sleep = false;
  const BodyId stone = world.create_body(block_def);
  FluidDef water_def;
  water_def.xsph = 20;
  const FluidId water = world.create_fluid(water_def);
  const auto count =
      static_cast<double>(world.add_fluid(block(water, {-half, 0.03f, -half}, {half, 0.18f, half})));
  run(world, 300, dt);
  double on_pins = 0, on_stone = 0, on_water = 0;
  constexpr int steps = 150;
  for (int k = 0; k < steps; ++k) {
    world.step(dt);
    on_pins += double{world.attachment_force(pins).y} / steps;
    on_stone += double{world.body_state(stone).fluid_force.y} / steps;
    for (const ParticleContact& c : world.particle_contacts()) on_water += double{c.impulse.y / dt} / steps;
  }
  const double gravity = 9.81, water_weight = gravity * count * double{world.particle_mass(water)};
  const double stone_weight = gravity * double{world.body_mass(stone).mass};
  const double all = water_weight + stone_weight + gravity * double{world.cloth_state(cloth).mass};
  RecordProperty("pins_over_weight", std::to_string(-on_pins / all));
  RecordProperty("block_over_weight", std::to_string(on_stone / stone_weight));
  RecordProperty("water_over_weight", std::to_string(on_water / water_weight));
  EXPECT_NEAR(-on_pins / all, 1, 0.02);
  EXPECT_NEAR(on_stone / stone_weight, 1, 0.02);
  EXPECT_NEAR(on_water / water_weight, 1, 0.02);
}

MENISCUS_WITH_EACH_RIGID_SOLVER(ThreeTogether);

}  // namespace
}  // namespace meniscus::tests
