// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The pressure grid of a world on several ranks: the same bits as alone, on each device.
#include <gtest/gtest.h>

#include "tests/ranks/bodies.h"
#include "tests/ranks/broken_dam.h"
#include "tests/ranks/flow.h"
#include "tests/ranks/share.h"

namespace meniscus::tests {
namespace {

constexpr float frame = 0.008f;                // s
constexpr float width = 0.15f, length = 1.3f;  // m

class SharedGrid : public OnDevice {
 protected:
  std::optional<int> gpu() const {
    return GetParam() == pbd::DeviceKind::cuda ? std::optional(0) : std::nullopt;
  }
  WorldDef def() const {
    WorldDef def = world_def(GetParam(), 0.05f);
    def.sums = Sums::fixed;
    def.threads = 1;
    def.density.solver = DensitySolver::grid;
    return def;
  }
  World dam(bool has_bodies) const {
    World world = broken_dam(width, length, true, gpu(), true, RigidSolver::bullet, true);
    if (has_bodies) add_bodies(world, width, length);
    return world;
  }
  static std::vector<std::string> told(World& world, int steps) {
    std::vector<std::string> all;
    for (int k = 0; k < steps; ++k) {
      world.step(frame);
      if (k % 3 == 2) all.push_back(std::to_string(world.state_hash()) + " " + told_by_bodies(world));
    }
    return all;
  }
  static void expect_the_same(const std::function<World()>& make, int steps) {
    tests::expect_the_same(make, [&](World& world) { return told(world, steps); });
  }
};

TEST_P(SharedGrid, ADamHasTheSameBits) {
  expect_the_same([&] { return dam(false); }, 18);
}

TEST_P(SharedGrid, BodiesHaveTheSameBits) {
  expect_the_same([&] { return dam(true); }, 12);
}

/// With the slabs along y.
TEST_P(SharedGrid, APoolUnderGravityAlongZHasTheSameBits) {
  expect_the_same(
      [&] {
        WorldDef d = def();
        d.gravity = {0, 0, -9.81f};
        World world(d);
        world.create_shape(tank({0, 0, 0}, {0.3f, 2, 1}));
        world.create_shape(shape(SphereGeometry{0.12f}, {0.15f, 0.6f, 0.1f}));
        world.add_fluid(block(world.create_fluid({}), {0, 0, 0}, {0.3f, 1.2f, 0.5f}));
        return world;
      },
      12);
}

/// Some ranks have nothing at first.
TEST_P(SharedGrid, AJetIntoAnEmptyTankHasTheSameBits) {
  expect_the_same([&] { return jet_into_an_empty_tank(def()); }, 45);
}

/// A layer far away shares its entries of the table with others, which are on other ranks.
TEST_P(SharedGrid, FluidFarApartIsRefused) {
  const auto errors = share(
      2, {},
      [&] {
        World world(def());
        const FluidId fluid = world.create_fluid({});
        world.add_fluid(block(fluid, {0, 0, 0}, {0.3f, 0.3f, 1}));
        world.add_fluid(block(fluid, {0, 0, 900}, {0.3f, 0.3f, 901}));
        return world;
      },
      [](World& world) { world.step(frame); });
  for (const std::string& error : errors) EXPECT_NE(error.find("pressure grid"), std::string::npos) << error;
}

MENISCUS_ON_EACH_DEVICE(SharedGrid);

}  // namespace
}  // namespace meniscus::tests
