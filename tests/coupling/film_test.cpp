// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Bodies that are flush on a floor, or on one another, under water.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/coupling/body_worlds.h"
#include "tests/rigid_solvers.h"

namespace meniscus::tests {
namespace {

constexpr float s = 0.04f, dt = 0.016f, gravity = 9.81f, depth = 0.4f;

class FilmTest : public WithSolver {
 protected:
  /// A tank of 0.8 × 0.8 m, with a hole in its floor this wide, m.
  static ShapeId add_tank(World& world, float hole = 0) {
    ShapeDef def = shape(ContainerGeometry{{0.4f, 0.6f, 0.4f}, {{Face::y_high, {}}}}, {0, 0.6f, 0});
    const float half = 0.5f * hole;
    if (hole > 0)
      std::get<ContainerGeometry>(def.geometry)
          .openings.push_back({Face::y_low, Aabb{{-half, -1, -half}, {half, 1, half}}});
    return world.create_shape(def);
  }
  static void add_water(World& world) {
    FluidDef water;
    water.xsph = 10;
    world.add_fluid(block(world.create_fluid(water), {-0.4f, 0, -0.4f}, {0.4f, depth, 0.4f}));
  }
  /// The mean upward force of the fluid on a body over some steps, N.
  static double mean_lift(World& world, BodyId id, int steps) {
    double sum = 0;
    for (int k = 0; k < steps; ++k) {
      world.step(dt);
      sum += double{world.body_state(id).fluid_force.y} / steps;
    }
    return sum;
  }
  static BodyDef crate(float density) {
    return body(BoxGeometry{{0.12f, 0.12f, 0.12f}}, {0, 0.12f, 0}, density);
  }

  static constexpr double lift = 1000 * 9.81 * 0.24 * 0.24 * 0.24;  // N, by Archimedes
};

// A plate's foot carries five times its lift, a crate's 1.7 times.
TEST_P(FilmTest, TheForceOnWhatIsFlushOnTheFloorIsThatOfArchimedes) {
  for (const Vec3 half : {Vec3{0.12f, 0.12f, 0.12f}, Vec3{0.2f, 0.04f, 0.2f}}) {
    World world(world_def(GetParam(), s));
    const ShapeId box = add_tank(world);
    const BodyId held = world.create_body(kinematic(BoxGeometry{half}, {0, half.y, 0}));
    add_water(world);
    const double water = double(world.particle_count()) * 1000 * double{s * s * s * gravity};
    const double expected = 8 * 1000 * double{half.x * half.y * half.z * gravity};
    run(world, 40, dt);
    ProbeDef floor;
    floor.kind = ProbeKind::wall_force;
    floor.shape = box;
    floor.patch = Aabb{{-1, -0.01f, -1}, {1, 0.01f, 1}};
    const ProbeId probe = world.create_probe(floor);
    floor.kind = ProbeKind::wall_torque;
    floor.point = {1, 0, 0};
    const ProbeId torque = world.create_probe(floor);
    constexpr int steps = 20;
    double force = 0, on_floor = 0, about_z = 0;
    for (int k = 0; k < steps; ++k) {
      world.step(dt);
      force += double{world.body_state(held).fluid_force.y} / steps;
      on_floor += double{world.probe(probe)} / steps;
      about_z += double{world.probe_vector(torque).z} / steps;
    }
    RecordProperty("lift_over_archimedes", std::to_string(force / expected));
    EXPECT_NEAR(force, expected, 0.01 * expected);
    EXPECT_NEAR(on_floor, water + expected, 0.01 * (water + expected));
    EXPECT_NEAR(about_z, on_floor, 0.02 * on_floor);  // 1 m beside the middle
  }
}

// One on the floor, and one on a heavy box. In water they weigh a tenth of their lift.
TEST_P(FilmTest, BodiesLittleHeavierThanWaterStay) {
  World world(world_def(GetParam(), 0.05f));
  add_tank(world);
  const BoxGeometry box{{0.1f, 0.08f, 0.1f}};
  world.create_body(body(box, {-0.2f, 0.08f, 0}, 8000));
  const BodyId on_box = world.create_body(body(box, {-0.19f, 0.24f, 0.01f}, 1100)),
               on_floor = world.create_body(body(box, {0.2f, 0.08f, 0}, 1100));
  add_water(world);
  float highest[] = {0, 0};
  for (int k = 0; k < 312; ++k) {
    world.step(dt);
    highest[0] = std::max(highest[0], world.body_state(on_box).pose.position.y);
    highest[1] = std::max(highest[1], world.body_state(on_floor).pose.position.y);
  }
  EXPECT_LT(highest[0], 0.245f);
  EXPECT_LT(highest[1], 0.085f);
}

TEST_P(FilmTest, ALightCrateRisesFromTheFloor) {
  World world(world_def(GetParam(), s));
  add_tank(world);
  const BodyId light = world.create_body(crate(300));
  add_water(world);
  run(world, 50, dt);
  EXPECT_GT(world.body_state(light).pose.position.y, 0.25f);
}

TEST_P(FilmTest, TheFloorBearsWhatAHeavyCrateWeighsInWater) {
  WorldDef def = world_def(GetParam(), s);
  def.substeps = 1;  // so that each contact can be read
  World world(def);
  add_tank(world);
  BodyDef heavy = crate(1100);
  heavy.can_sleep = false;
  const BodyId id = world.create_body(heavy);
  add_water(world);
  run(world, 160, 0.004f);
  constexpr int steps = 120;
  double force = 0, floor = 0;
  for (int k = 0; k < steps; ++k) {
    world.step(0.004f);
    force += double{world.body_state(id).fluid_force.y} / steps;
    for (const SolidContact& c : world.solid_contacts())
      floor += double{c.impulse * c.normal.y / 0.004f} / steps;
  }
  const double weight = 1.1 * lift;
  EXPECT_NEAR(force, lift, 0.01 * lift);
  EXPECT_NEAR(floor, weight - force, 0.01 * weight);
}

// Without the film it is −90 N until particles wedge in, and then rises to 180 N.
TEST_P(FilmTest, TheForceIsSteadyWhileABodyIsLifted) {
  World world(world_def(GetParam(), s));
  add_tank(world);
  BodyDef lifted = kinematic(crate(1000).geometry, {0, 0.12f, 0});
  lifted.keyframes = {{0, {0, 0.12f, 0}}, {0.64f, {0, 0.12f, 0}}, {1.44f, {0, 0.12f + 0.8f * s, 0}}};
  const BodyId id = world.create_body(lifted);
  add_water(world);
  run(world, 40, dt);
  for (int k = 0; k < 5; ++k) {
    const double force = mean_lift(world, id, 10);
    EXPECT_GT(force, 0.9 * lift) << k;
    EXPECT_LT(force, 1.1 * lift) << k;
  }
}

// The pressure falls from the outer rim, which is in water, to that of the hole, which is in air. Its mean
// over the plug's foot, over the pressure of the water, is that of Laplace's equation over a square ring.
TEST_P(FilmTest, APlugOverADrainIsHeldWithTheFilmsIntegral) {
  constexpr float width = 0.4f, hole = 0.2f, height = 0.08f;
  constexpr int cells = 40;
  std::vector<std::vector<double>> u(cells + 1, std::vector<double>(cells + 1, 1));
  const auto is_open = [](int i, int j) { return std::max(std::abs(i - 20), std::abs(j - 20)) <= 10; };
  for (int sweep = 0; sweep < 400; ++sweep)
    for (int i = 1; i < cells; ++i)
      for (int j = 1; j < cells; ++j)
        u[i][j] = is_open(i, j)
                      ? 0
                      : -0.8 * u[i][j] + 0.45 * (u[i - 1][j] + u[i + 1][j] + u[i][j - 1] + u[i][j + 1]);
  double mean = 0;
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j)
      mean += 0.25 * (u[i][j] + u[i + 1][j] + u[i][j + 1] + u[i + 1][j + 1]) / (cells * cells);

  World world(world_def(GetParam(), s));
  add_tank(world, hole);
  const BoxGeometry plate{{0.5f * width, 0.5f * height, 0.5f * width}};
  const BodyId plug = world.create_body(kinematic(plate, {0, 0.5f * height, 0}));
  add_water(world);
  run(world, 30, dt);
  const double force = mean_lift(world, plug, 20), area = double{width * width};
  const double above = 9810 * double{depth - height} * area, film = 9810 * double{depth} * area * mean;
  RecordProperty("film_over_expected", std::to_string((force + above) / film));
  EXPECT_NEAR(force + above, film, 0.1 * film);
}

TEST_P(FilmTest, ACrateOnACrateIsLiftedToo) {
  World world(world_def(GetParam(), s));
  add_tank(world);
  const BodyId lower = world.create_body(kinematic(crate(1000).geometry, {0, 0.12f, 0}));
  const BodyId upper = world.create_body(kinematic(BoxGeometry{{0.08f, 0.06f, 0.08f}}, {0, 0.3f, 0}));
  add_water(world);
  run(world, 40, dt);
  double below = 0, above = 0;
  constexpr int steps = 20;
  for (int k = 0; k < steps; ++k) {
    world.step(dt);
    below += double{world.body_state(lower).fluid_force.y} / steps;
    above += double{world.body_state(upper).fluid_force.y} / steps;
  }
  EXPECT_NEAR(below, lift, 0.03 * lift);
  // Its top is one spacing beneath the surface, where particles exert least.
  EXPECT_NEAR(above, 9810 * 0.16 * 0.16 * 0.12, 0.05 * 9810 * 0.16 * 0.16 * 0.12);
}

MENISCUS_WITH_EACH_RIGID_SOLVER(FilmTest);

}  // namespace
}  // namespace meniscus::tests
