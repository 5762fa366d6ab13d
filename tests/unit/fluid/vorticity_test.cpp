// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Vorticity confinement in whole worlds: what it needs of the last substep is still there in the next.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

class VorticityTest : public OnDevice {
 protected:
  /// The remaining fraction of the kinetic energy of a vortex in a full tank without gravity.
  static double energy_left(FluidDef def, float confinement) {
    constexpr float s = 0.05f;
    WorldDef world_def = tests::world_def(GetParam(), s);
    world_def.gravity = {0, 0, 0};
    World world(world_def);
    world.create_shape(tank({-8 * s, -8 * s, -4 * s}, {8 * s, 8 * s, 4 * s}));
    def.vorticity_confinement = confinement;
    const std::vector<Vec3> positions = lattice(16, 16, 8, s, {-8 * s, -8 * s, -4 * s});
    std::vector<Vec3> velocities;
    for (Vec3 x : positions)
      velocities.push_back(5 * std::exp(-(x.x * x.x + x.y * x.y) / (16 * s * s)) * Vec3{-x.y, x.x, 0});
    world.add_particles(world.create_fluid(def), positions, velocities);
    const double before = energy(world);
    run(world, 100, 0.004f);
    return energy(world) / before;
  }

 private:
  static double energy(const World& world) {
    double sum = 0;
    for (Vec3 v : world.velocities()) sum += dot(v, v);
    return sum;
  }
};

TEST_P(VorticityTest, ConfinementKeepsAVortexTurning) {
  EXPECT_GT(energy_left({}, 0.5f), 1.1 * energy_left({}, 0));
}

TEST_P(VorticityTest, AlsoUnderSurfaceTension) {
  FluidDef water;
  water.surface_tension = 0.07f;
  EXPECT_GT(energy_left(water, 0.5f), 1.1 * energy_left(water, 0));
}

MENISCUS_ON_EACH_DEVICE(VorticityTest);

}  // namespace
}  // namespace meniscus::tests
