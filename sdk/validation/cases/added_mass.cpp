// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The water that an accelerated ball carries along.
#include <cmath>

#include "sdk/validation/cases/cases.h"
#include "sdk/validation/parts.h"

namespace meniscus::validation {
namespace {

constexpr float radius = 0.15f, half = 4 * radius, depth = 7 * radius;  // m
constexpr float step = 1 / 60.0f;
constexpr double push = 0.5;  // weights of the ball

/// The speed along x over time, of a ball as dense as water that is pushed along x.
Curve speed_after_push(const Settings& settings, float spacing, double force_in_weights) {
  World world(settings.world(spacing));
  world.create_shape(tank({-half, 0, -half}, {half, 2 * depth, half}));
  BodyDef def = body(SphereGeometry{radius}, {0, 0.5f * depth, 0}, 1000);
  def.can_sleep = false;
  const BodyId ball = world.create_body(def);
  FluidDef water;
  water.xsph = 0;
  FluidVolumeDef pool = block(world.create_fluid(water), {-half, 0, -half}, {half, depth, half});
  pool.seeding = Seeding::disordered;
  world.add_fluid(pool);
  run(world, 0.5, step);
  world.set_body_velocity(ball, {0, 0, 0}, {0, 0, 0});
  const auto force = static_cast<float>(force_in_weights * double{world.body_mass(ball).mass} * 9.81);
  Curve speed{"measured"};
  const double start = world.time();
  for (int k = 0; k < 6; ++k) {
    world.apply_force(ball, {force, 0, 0}, world.body_state(ball).centre_of_mass);
    world.step(step);
    speed.add(world.time() - start, double{world.body_state(ball).velocity.x});
  }
  return speed;
}

Result result_of(const Settings& settings) {
  const float spacing = radius / float(settings.choose(3, 5, 10));
  Curve speed = speed_after_push(settings, spacing, push);
  const Curve opposite = speed_after_push(settings, spacing, -push);
  Curve theory{"added mass 1/2"}, none{"no added mass"};
  for (std::size_t k = 0; k < speed.y.size(); ++k) {
    speed.y[k] = 0.5 * (speed.y[k] - opposite.y[k]);
    theory.add(speed.x[k], push * 9.81 * speed.x[k] / 1.5);
    none.add(speed.x[k], push * 9.81 * speed.x[k]);
  }
  const double mass = push * 9.81 * speed.x.back() / speed.y.back() - 1;
  Result result;
  result.within("added mass over that of the displaced water", "", mass, 0.45, 0.55, Bar::target,
                "The ball has a radius of few spacings, and is slowed more the longer it is pushed. Whether "
                "that is all is not known.");
  result.plots = {{"Speed of a ball that is pushed", "time (s)", "speed (m/s)", {speed, theory, none}}};
  return result;
}

}  // namespace

Case added_mass() {
  return {"added-mass", "Added mass of a ball",
          "A ball with a radius of 0.15 m, as dense as water, is in the middle of a tank 1.2 m wide with 1.2 "
          "m of "
          "water. The water was seeded without order. A force of half its weight pushes it sideways for 0.1 "
          "s. The speed is half the difference "
          "between a push to the right and one to the left, so that residual motion cancels.",
          "Potential flow: half of the displaced mass (H. Lamb, Hydrodynamics, art. 92). Walls at four radii "
          "add less than 3 %.",
          result_of};
}

}  // namespace meniscus::validation
