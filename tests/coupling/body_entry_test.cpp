// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A ball falls into a tank: the total momentum changes by the impulses of gravity and the walls.
#include <gtest/gtest.h>

#include "tests/coupling/body_worlds.h"

namespace meniscus::tests {
namespace {

class BodyEntryTest : public OnDevice {};

TEST_P(BodyEntryTest, TheWholeGainsWhatGravityAndTheWallsGive) {
  WorldDef def = world_def(GetParam(), 0.05f);
  def.substeps = 1;
  World world(def);
  world.create_shape(tank({-0.4f, 0, -0.4f}, {0.4f, 1.5f, 0.4f}));
  const FluidId water = world.create_fluid({});
  world.add_fluid(block(water, {-0.4f, 0, -0.4f}, {0.4f, 0.5f, 0.4f}));
  BodyDef falling = body(SphereGeometry{0.15f}, {0.05f, 0.7f, 0.02f}, 1500);
  falling.velocity = {0.3f, -3, 0};
  falling.surface.solid_friction = 0;  // contacts of solids are read without it
  const BodyId ball = world.create_body(falling);
  const double mass = double{world.body_mass(ball).mass} +
                      double{world.particle_mass(water)} * static_cast<double>(world.particle_count());

  const Momentum start = fluid_momentum(world, water) + body_momentum(world, ball);
  Sum3 given;
  for (int k = 0; k < 250; ++k) {
    const double before = world.time();
    world.step(0.004f);
    given += (world.time() - before) * mass * Sum3(0, -9.81, 0);
    // What the ball gets beyond what its particles give is from a film, whose other face is a wall.
    for (const ParticleContact& c : world.particle_contacts()) given += c.impulse;
    given += (world.time() - before) * Sum3(world.body_state(ball).fluid_force);
    for (const SolidContact& c : world.solid_contacts()) given += double{c.impulse} * Sum3(c.normal);
  }
  const Momentum end = fluid_momentum(world, water) + body_momentum(world, ball);
  const double entry = double{world.body_mass(ball).mass} * std::hypot(0.3, 3.0);
  const double gap = norm(end.linear - start.linear - given);
  RecordProperty("gap_percent_of_the_balls_momentum", std::to_string(100 * gap / entry));
  EXPECT_LT(gap, 0.01 * entry);
  EXPECT_LT(world.body_state(ball).pose.position.y, 0.3f);  // it did go in
}

MENISCUS_ON_EACH_DEVICE(BodyEntryTest);

}  // namespace
}  // namespace meniscus::tests
