// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Groups and masks: which objects pass through each other.
#include <gtest/gtest.h>

#include "tests/rigid_solvers.h"
#include "tests/unit/sdk/world/solids/body_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float dt = 0.01f;
constexpr CollisionFilter ghost{2, 0xffffffffu};      ///< is of group 2
constexpr CollisionFilter no_ghosts{1, 0xfffffffdu};  ///< ignores group 2

class BodyFilterTest : public WithSolver {
 protected:
  World world_{world_def(GetParam(), 0.05f)};

  static BodyDef cube(Vec3 position, CollisionFilter filter = {}) {
    BodyDef def = body(BoxGeometry{{0.1f, 0.1f, 0.1f}}, position);
    def.filter = filter;
    return def;
  }
  float height(BodyId id) const { return world_.body_state(id).pose.position.y; }
};

TEST_P(BodyFilterTest, BodiesThatIgnoreOneAnotherPassThrough) {
  world_.create_shape(shape(PlaneGeometry{}));
  const BodyId still = world_.create_body(cube({0, 0.1f, 0}, ghost));
  const BodyId through = world_.create_body(cube({0, 0.5f, 0}, no_ghosts));
  run(world_, 100, dt);
  EXPECT_NEAR(height(still), 0.1f, 0.01f);
  EXPECT_NEAR(height(through), 0.1f, 0.01f);
  const BodyId onto = world_.create_body(cube({0, 0.5f, 0}));
  run(world_, 100, dt);
  EXPECT_NEAR(height(onto), 0.3f, 0.01f);
}

TEST_P(BodyFilterTest, AMaskOnEitherSideIsEnough) {
  for (bool fixed_ignores : {false, true}) {
    World world(world_def(GetParam(), 0.05f));
    ShapeDef floor = shape(PlaneGeometry{});
    floor.filter = fixed_ignores ? no_ghosts : ghost;
    world.create_shape(floor);
    const BodyId falls = world.create_body(cube({0, 0.2f, 0}, fixed_ignores ? ghost : no_ghosts));
    const BodyId lies = world.create_body(cube({1, 0.2f, 0}, floor.filter));
    run(world, 50, dt);
    EXPECT_LT(world.body_state(falls).pose.position.y, -0.5f);
    EXPECT_NEAR(world.body_state(lies).pose.position.y, 0.1f, 0.01f);
  }
}

/// Water that ignores ghosts, in a tank.
class FluidFilterTest : public BodyFilterTest {
 protected:
  FluidId water_ = make_water();

  FluidId make_water() {
    world_.create_shape(open_tank({0.25f, 0.5f, 0.25f}));
    FluidDef def;
    def.filter = no_ghosts;
    return world_.create_fluid(def);
  }
  size_t fill() { return world_.add_fluid(block(water_, {-0.25f, 0, -0.25f}, {0.25f, 0.3f, 0.25f})); }
};

TEST_P(FluidFilterTest, ABodyFallsThroughFluidThatIgnoresIt) {
  fill();
  const BodyId sinks = world_.create_body(cube({0, 0.5f, 0}, ghost));
  float most = 0;
  for (int k = 0; k < 30; ++k) {
    world_.step(dt);
    most = std::max(most, length(world_.body_state(sinks).fluid_force));
  }
  EXPECT_EQ(most, 0);
  for (const ParticleContact& c : world_.particle_contacts()) EXPECT_FALSE(c.body == sinks);
  run(world_, 40, dt);
  EXPECT_NEAR(height(sinks), 0.1f, 0.01f);
}

TEST_P(FluidFilterTest, AShapeIsNothingToFluidThatIgnoresIt) {
  ShapeDef def = shape(BoxGeometry{{0.1f, 0.15f, 0.1f}}, {0, 0.15f, 0});
  def.filter = ghost;
  world_.create_shape(def);
  EXPECT_EQ(fill(), 10u * 6u * 10u);  // nor is it when the fluid is seeded
  run(world_, 30, dt);
  size_t within = 0;
  for (Vec3 p : world_.positions()) within += max_component(abs(p - Vec3{0, 0.15f, 0})) < 0.1f;
  EXPECT_GT(within, 40u);
  EXPECT_EQ(world_.diagnostics().outside, 0u);
}

TEST_P(FluidFilterTest, OtherFluidIsHeldByWhatThisOneIgnores) {
  const FluidId plain = world_.create_fluid({});
  ShapeDef plate = shape(BoxGeometry{{0.25f, 0.05f, 0.25f}}, {0, 0.5f, 0});
  plate.filter = ghost;
  world_.create_shape(plate);
  world_.add_particles(water_, std::vector<Vec3>{{-0.1f, 0.6f, 0}});
  world_.add_particles(plain, std::vector<Vec3>{{0.1f, 0.6f, 0}});
  run(world_, 60, dt);
  EXPECT_NEAR(world_.positions()[0].y, 0.025f, 0.002f);
  EXPECT_NEAR(world_.positions()[1].y, 0.575f, 0.002f);
}

MENISCUS_WITH_EACH_RIGID_SOLVER(BodyFilterTest);
MENISCUS_WITH_EACH_RIGID_SOLVER(FluidFilterTest);

}  // namespace
}  // namespace meniscus::tests
