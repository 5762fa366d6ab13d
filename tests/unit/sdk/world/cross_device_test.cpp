// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The CPU and the GPU solve the same problem. They sum in another order, so that bits differ, and what is
// chaotic drifts apart: one substep agrees closely, a settled tank in its means.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

class CrossDeviceTest : public OnDevice {
 protected:
  /// Two layers, each of eight particles along y and so many along x and z.
  static World one_substep(pbd::DeviceKind kind, DensitySolver solver, int wide, int deep) {
    WorldDef def = world_def(kind, 0.05f);
    def.substeps = 1;
    def.iterations = 4;
    def.density.solver = solver;
    def.density.artificial_pressure.strength = 0.05f;
    World world(def);
    FluidDef first, second;
    first.vorticity_confinement = 0.2f;
    second.rest_density = 500;
    const FluidId a = world.create_fluid(first), b = world.create_fluid(second);
    const auto fits = [](int particles) { return std::max(0.5f, 0.05f * static_cast<float>(particles)); };
    ShapeDef walls = tank({0, 0, 0}, {2 * fits(wide), 1, fits(deep)});
    walls.surface.friction = 0.2f;
    world.create_shape(walls);
    world.create_shape(shape(SphereGeometry{0.2f}, {0.3f, 0.1f, 0.25f}));
    std::mt19937 random(17);
    for (FluidId id : {a, b}) {
      std::vector<Vec3> positions, velocities;
      for (Vec3 p : lattice(wide, 8, deep, 0.049f, {0.001f, id == a ? 0.003f : 0.4f, 0.002f})) {
        positions.push_back(p + random_vector(random, 0.005f));
        velocities.push_back(random_vector(random, 0.5f));
      }
      world.add_particles(id, positions, velocities);
    }
    world.step(0.004f);
    return world;
  }

  /// How far the devices are apart after one substep, in support radii, by particle; density errors may
  /// differ by so many times as much.
  std::vector<float> differences(DensitySolver solver, int wide, int deep, float times) {
    const World cpu = one_substep(pbd::DeviceKind::cpu, solver, wide, deep),
                other = one_substep(GetParam(), solver, wide, deep);
    const float h = cpu.support_radius();
    std::vector<float> apart;
    for (size_t i = 0; i < cpu.particle_count(); ++i) {
      apart.push_back(std::max(length(cpu.positions()[i] - other.positions()[i]),
                               0.004f * length(cpu.velocities()[i] - other.velocities()[i])) /
                      h);
      EXPECT_NEAR(cpu.density_errors()[i], other.density_errors()[i], times * apart.back() + 1e-3)
          << "particle " << i;
    }
    EXPECT_EQ(cpu.diagnostics().contacts, other.diagnostics().contacts);
    return apart;
  }
};

TEST_P(CrossDeviceTest, OneSubstepIsTheSameToRounding) {
  for (DensitySolver solver : {DensitySolver::jacobi, DensitySolver::chebyshev}) {
    const std::vector<float> apart = differences(solver, 8, 10, 0);
    EXPECT_LT(*std::max_element(apart.begin(), apart.end()), 1e-4f);
  }
}

/// A GPU then runs what touches walls, and what does not, in launches side by side. And it lists pairs by
/// coarse positions: a pair that was h apart, give or take three thousandths, and comes nearer in the solve,
/// may count on one device alone.
TEST_P(CrossDeviceTest, ThatOfAQuarterOfAMillionParticlesIsButForPairsAtTheEdgeOfReach) {
  std::vector<float> apart = differences(DensitySolver::chebyshev, 125, 125, 10);
  std::sort(apart.begin(), apart.end());
  EXPECT_LT(apart[apart.size() * 99 / 100], 1e-4f);
  EXPECT_LT(apart.back(), 0.01f);
}

TEST_P(CrossDeviceTest, AfterTwoSecondsTheMeansAgree) {
  World cpu = dam_break(pbd::DeviceKind::cpu), other = dam_break(GetParam());
  for (World* world : {&cpu, &other}) run(*world, 125, 0.016f);
  EXPECT_NEAR(mean_height(other) / mean_height(cpu), 1, 0.01);
  EXPECT_NEAR(energy(other) / energy(cpu), 1, 0.01);
}

std::vector<pbd::DeviceKind> all_but_the_cpu() {
  std::vector<pbd::DeviceKind> kinds = usable_devices();
  std::erase(kinds, pbd::DeviceKind::cpu);
  return kinds;
}

// With the CPU alone there is nothing to compare, and no test.
INSTANTIATE_TEST_SUITE_P(On, CrossDeviceTest, testing::ValuesIn(all_but_the_cpu()), device_test_name);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(CrossDeviceTest);

}  // namespace
}  // namespace meniscus::tests
