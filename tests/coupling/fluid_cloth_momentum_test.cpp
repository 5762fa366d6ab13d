// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Water that meets a free sheet as heavy as itself: the momentum of both together.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/cloth_worlds.h"
#include "tests/coupling/body_worlds.h"

namespace meniscus::tests {
namespace {

class FluidClothMomentum : public OnDevice {};

/// Σ m |r| |v| about the origin.
double levers(const World& world, FluidId fluid, ClothId cloth) {
  double sum = 0;
  const auto add = [&](double mass, std::span<const Vec3> x, std::span<const Vec3> v) {
    for (size_t i = 0; i < x.size(); ++i) sum += mass * norm(x[i]) * norm(v[i]);
  };
  add(double{world.particle_mass(fluid)}, world.positions(), world.velocities());
  const auto x = world.cloth_positions(cloth);
  add(double{world.cloth_state(cloth).mass} / static_cast<double>(x.size()), x,
      world.cloth_velocities(cloth));
  return sum;
}

/// The angular part is far from exact: see docs/methods/fluid-cloth.md. The bound notices when it gets worse.
TEST_P(FluidClothMomentum, OfWaterThatStrikesAHeavySheet) {
  WorldDef def = world_def(GetParam(), 0.05f);
  def.gravity = {0, 0, 0};
  World world(def);
  world.set_wind({.air_density = 0});
  const FluidId water = world.create_fluid({});
  ClothDef heavy = sheet(0.7f, 0.7f, 15, 15);
  heavy.pose.rotation = about_z(10);
  heavy.self_collision = false;
  heavy.fabric.density = 10 / 0.49f;
  heavy.fabric.fluid_friction = 0.5f;
  const ClothId cloth = world.create_cloth(heavy);
  FluidVolumeDef ball;
  ball.fluid = water;
  ball.region = BallRegion{0.17f};
  ball.pose.position = {0.1f, 0.27f, 0.05f};
  ball.velocity = {0.5f, -2, 0.3f};
  world.add_fluid(ball);
  const auto momentum = [&] { return fluid_momentum(world, water) + cloth_momentum(world, cloth); };
  const Momentum before = momentum();
  double linear = 0, angular = 0, lever = levers(world, water, cloth);
  for (int k = 0; k < 200; ++k) {
    world.step(1 / 60.0f);
    const Momentum now = momentum();
    linear = std::max(linear, norm(now.linear - before.linear) / before.gross);
    if (k >= 60) continue;
    lever = std::max(lever, levers(world, water, cloth));
    angular = std::max(angular, norm(now.angular - before.angular) / lever);
  }
  RecordProperty("linear_drift", std::to_string(1e6 * linear) + "e-6");
  RecordProperty("angular_drift", std::to_string(1e3 * angular) + "e-3");
  EXPECT_LT(linear, 1e-6);
  EXPECT_LT(angular, 0.035);
  EXPECT_LT(cloth_momentum(world, cloth).linear.y, -5) << "they did not meet";
}

MENISCUS_ON_EACH_DEVICE(FluidClothMomentum);

}  // namespace
}  // namespace meniscus::tests
