// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The exchange of momentum between fluid and bodies: impulses are equal and opposite, and momentum is
// conserved.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/coupling/body_worlds.h"
#include "tests/rigid_solvers.h"

namespace meniscus::tests {
namespace {

constexpr float s = 0.05f;

/// A body that flies and turns into a block of water, far from all else, without weight.
struct Meeting {
  World world;
  FluidId water{};
  BodyId body{};

  Meeting(WorldDef def, const Geometry& geometry, float friction, float xsph)
      : world((def.gravity = {0, 0, 0}, def)) {
    FluidDef fluid;
    fluid.xsph = xsph;
    water = world.create_fluid(fluid);
    BodyDef flying = tests::body(geometry, {0, 0, 0}, 600);
    flying.velocity = {1.5f, 0.3f, 0};
    flying.angular_velocity = {1, 3, 2};
    flying.surface.friction = friction;
    flying.can_sleep = false;
    body = world.create_body(flying);
    world.add_fluid(block(water, {0.3f, -0.3f, -0.3f}, {0.6f, 0.3f, 0.3f}));
  }

  Momentum momentum() const { return fluid_momentum(world, water) + body_momentum(world, body); }
};

/// The device has no cylinders.
CompoundGeometry anvil(RigidSolver solver) {
  Geometry neck = CylinderGeometry{0.1f, 0.1f};
  if (solver == RigidSolver::device) neck = CapsuleGeometry{0.1f, 0.1f};
  return {{part(BoxGeometry{{0.2f, 0.05f, 0.2f}}, {0, -0.1f, 0}), part(neck, {0, 0.05f, 0}),
           part(SphereGeometry{0.12f}, {0.1f, 0.15f, 0})}};
}

class BodyExchangeTest : public WithSolver {
 protected:
  static std::vector<Geometry> bodies() {
    return {BoxGeometry{{0.2f, 0.15f, 0.25f}}, SphereGeometry{0.25f}, anvil(GetParam().solver)};
  }

  /// The largest drift of the total momentum, as a fraction of Σ m · speed, in 200 steps.
  static double linear_drift(Meeting& scene) {
    const Momentum start = scene.momentum();
    double gross = start.gross, drift = 0;
    for (int k = 0; k < 200; ++k) {
      scene.world.step(0.008f);
      const Momentum now = scene.momentum();
      gross = std::max(gross, now.gross);
      drift = std::max(drift, norm(now.linear - start.linear));
    }
    return drift / gross;
  }

  /// kg·m²/s after 0.32 s, over the whole that was there.
  static double angular_drift(Meeting& scene) {
    const Momentum start = scene.momentum();
    run(scene.world, 40, 0.008f);
    return norm(scene.momentum().angular - start.angular) / norm(start.angular);
  }
};

TEST_P(BodyExchangeTest, LinearMomentumIsKept) {
  float friction = 0;
  for (const Geometry& geometry : bodies()) {
    Meeting scene(world_def(GetParam(), s), geometry, friction, 5);
    const double drift = linear_drift(scene);
    RecordProperty("geometry_" + std::to_string(geometry.index()), std::to_string(1e6 * drift) + "e-6");
    EXPECT_LT(drift, 1e-5) << "geometry " << geometry.index() << ", friction " << friction;
    EXPECT_GT(norm(fluid_momentum(scene.world, scene.water).linear), 10);  // they have met
    friction += 0.4f;
  }
}

// Positions, and with them levers, are known to the order of the substep: a quarter of it, a quarter of the
// drift. XSPH is left out, as it is no central force.
TEST_P(BodyExchangeTest, AngularMomentumDriftsByTheOrderOfTheSubstep) {
  double drift[2];
  for (int fine : {0, 1}) {
    WorldDef def = world_def(GetParam(), s);
    def.substeps = fine ? 32 : 8;
    Meeting scene(def, BoxGeometry{{0.2f, 0.15f, 0.25f}}, 0.3f, 0);
    drift[fine] = angular_drift(scene);
  }
  RecordProperty("coarse", std::to_string(drift[0]));
  RecordProperty("fine", std::to_string(drift[1]));
  EXPECT_LT(drift[0], 0.01);
  EXPECT_NEAR(drift[1] / drift[0], 0.25, 0.04);
}

// In a step of one substep the contacts that can be read are all that there were.
TEST_P(BodyExchangeTest, WhatTheParticlesGetTheBodyGives) {
  for (const Geometry& geometry : bodies()) {
    WorldDef def = world_def(GetParam(), s);
    def.substeps = 1;
    const int additions = GetParam().solver == RigidSolver::device ? def.rigid.iterations / 2 : 1;
    Meeting scene(def, geometry, 0.4f, 5);
    double worst = 0, worst_reported = 0;
    int touching = 0;
    for (int k = 0; k < 150; ++k) {
      const Momentum before = body_momentum(scene.world, scene.body);
      scene.world.step(0.002f);
      Sum3 impulse;
      double gross = 0;
      for (const ParticleContact& c : scene.world.particle_contacts()) {
        ASSERT_EQ(c.body, scene.body);
        impulse += c.impulse;
        gross += norm(c.impulse);
      }
      const Momentum after = body_momentum(scene.world, scene.body);
      const BodyState state = scene.world.body_state(scene.body);
      if (gross == 0) continue;
      ++touching;
      const Sum3 left_over = after.linear - before.linear + impulse;
      // Momenta are floats times the mass: what roundings of the body's velocity are worth counts for
      // nothing. The device adds to it in each small step.
      const double rounding = 2e-7 * additions * after.gross;
      worst = std::max(worst, (norm(left_over) - rounding) / gross);
      const Sum3 given = 0.002 * Sum3(state.fluid_force);
      worst_reported = std::max(worst_reported, norm(given + impulse) / gross);
    }
    RecordProperty("worst_" + std::to_string(geometry.index()), std::to_string(1e6 * worst) + "e-6");
    RecordProperty("worst_reported_" + std::to_string(geometry.index()),
                   std::to_string(1e6 * worst_reported) + "e-6");
    EXPECT_GT(touching, 20);
    EXPECT_LT(worst, 1e-6) << "geometry " << geometry.index();
    EXPECT_LT(worst_reported, 1e-6) << "geometry " << geometry.index();
  }
}

MENISCUS_WITH_EACH_RIGID_SOLVER(BodyExchangeTest);

}  // namespace
}  // namespace meniscus::tests
