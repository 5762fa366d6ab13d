// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The baselines against closed forms: free fall, momentum, hydrostatics and Archimedes' law.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/coupling/body_worlds.h"
#include "tests/unit/fluid/baselines/baseline_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float s = baseline_spacing, gravity = 9.81f;

class BaselinePhysicsTest : public OnDevice {
 protected:
  WorldDef def(DensitySolver solver) const { return baseline_def(GetParam(), solver); }
  WorldDef in_space(DensitySolver solver) const {
    WorldDef d = def(solver);
    d.gravity = {0, 0, 0};
    return d;
  }
};

TEST_P(BaselinePhysicsTest, FreeFallIsExact) {
  for (DensitySolver solver : all_baselines) {
    World world(def(solver));
    world.add_particles(world.create_fluid({}), lattice(6, 6, 6, s, {-0.15f, -0.15f, -0.15f}));
    run(world, 30, baseline_frame);
    for (Vec3 v : world.velocities()) {
      EXPECT_NEAR(v.y, -0.5f * gravity, 2e-3f) << name_of(solver);
      EXPECT_NEAR(v.x, 0, 2e-3f) << name_of(solver);
    }
  }
}

// Two blocks of different density meet without weight.
TEST_P(BaselinePhysicsTest, MomentumIsKept) {
  for (DensitySolver solver : all_baselines) {
    World world(in_space(solver));
    FluidDef heavy, light;
    light.rest_density = 300;
    const FluidId a = world.create_fluid(heavy), b = world.create_fluid(light);
    add_moving(world, a, lattice(5, 7, 7, s, {-0.26f, -0.175f, -0.175f}), {1, 0, 0});
    add_moving(world, b, lattice(5, 7, 7, s, {0.01f, -0.15f, -0.175f}), {-1, 0, 0});
    const auto momentum = [&](FluidId of) {
      Momentum sum;
      for (size_t i = 0; i < world.particle_count(); ++i) {
        if (world.fluids()[i] == of.index)
          add(sum, double{world.particle_mass(of)}, world.positions()[i], world.velocities()[i]);
      }
      return sum;
    };
    const Momentum before = momentum(a) + momentum(b);
    run(world, 30, baseline_frame);
    const Momentum after = momentum(a) + momentum(b);
    EXPECT_LT(norm(after.linear - before.linear), 1e-5 * before.gross) << name_of(solver);
    EXPECT_LT(after.gross, before.gross) << name_of(solver);
    EXPECT_GT(momentum(b).linear.x, 0) << name_of(solver) << ": they have not met";
  }
}

TEST_P(BaselinePhysicsTest, MomentumIsKeptWithABody) {
  for (DensitySolver solver : all_baselines) {
    World world(in_space(solver));
    const FluidId water = world.create_fluid({});
    BodyDef flying = body(BoxGeometry{{0.2f, 0.15f, 0.25f}}, {0, 0, 0}, 600);
    flying.velocity = {1.5f, 0.3f, 0};
    flying.angular_velocity = {1, 3, 2};
    flying.can_sleep = false;
    const BodyId id = world.create_body(flying);
    world.add_fluid(block(water, {0.3f, -0.2f, -0.2f}, {0.5f, 0.2f, 0.2f}));
    const auto momentum = [&] { return fluid_momentum(world, water) + body_momentum(world, id); };
    const Momentum before = momentum();
    run(world, 40, baseline_frame);
    EXPECT_LT(norm(momentum().linear - before.linear), 1e-5 * before.gross) << name_of(solver);
    EXPECT_GT(norm(fluid_momentum(world, water).linear), 5) << name_of(solver) << ": they have not met";
  }
}

TEST_P(BaselinePhysicsTest, APoolIsHydrostatic) {
  constexpr float depth = 0.5f, width = 0.4f, at = 0.2f;
  for (DensitySolver solver : all_baselines) {
    Pool pool(def(solver), depth, width);
    ProbeDef point;
    point.kind = ProbeKind::point_pressure;
    point.point = {0.5f * width, at, 0.5f * width};
    point.radius = 2 * s;
    const ProbeId probe = pool.world.create_probe(point);
    run(pool.world, 60, baseline_frame);
    double pressure = 0;
    constexpr int frames = 60;
    for (int k = 0; k < frames; ++k) {
      pool.world.step(baseline_frame);
      pressure += double{pool.world.probe(probe)} / frames;
    }
    EXPECT_NEAR(pressure / (1000 * gravity * (depth - at)), 1, 0.05) << name_of(solver);
    double height = 0;
    for (Vec3 p : pool.world.positions()) height += p.y / double(pool.world.particle_count());
    EXPECT_NEAR(2 * height / depth, 1, 0.02) << name_of(solver);
  }
}

TEST_P(BaselinePhysicsTest, TheFloorCarriesTheWeight) {
  constexpr float depth = 0.4f, width = 0.4f;
  for (DensitySolver solver : all_baselines) {
    Pool pool(def(solver), depth, width);
    const double force = mean_force_on_floor(pool.world, pool.box, 60, 60, baseline_frame);
    EXPECT_NEAR(force / (1000 * gravity * depth * width * width), 1, 0.01) << name_of(solver);
  }
}

/// A box floats half in the water, and the pool is higher by what it displaces.
TEST_P(BaselinePhysicsTest, ABoxFloatsAtArchimedesDraft) {
  constexpr float depth = 0.3f, width = 0.5f, half = 0.1f;
  for (DensitySolver solver : all_baselines) {
    Pool pool(def(solver), depth, width);
    const BodyId box = pool.world.create_body(
        body(BoxGeometry{{half, half, half}}, {0.5f * width, depth + 0.03f, 0.5f * width}, 500));
    run(pool.world, 90, baseline_frame);
    double height = 0, force = 0;
    constexpr int frames = 30;
    for (int k = 0; k < frames; ++k) {
      pool.world.step(baseline_frame);
      height += double{pool.world.body_state(box).pose.position.y} / frames;
      force += double{pool.world.body_state(box).fluid_force.y} / frames;
    }
    const double displaced = 4 * half * half * half, level = depth + displaced / (width * width);
    EXPECT_NEAR(height, level, 0.15 * half) << name_of(solver);
    EXPECT_NEAR(force / (1000 * gravity * displaced), 1, 0.05) << name_of(solver);
  }
}

MENISCUS_ON_EACH_DEVICE(BaselinePhysicsTest);

}  // namespace
}  // namespace meniscus::tests
