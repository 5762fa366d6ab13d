// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// No particle passes through the walls of a moving container, even if they are thin and fast. The minute for
// which the figure is stated is in validation/rigid_vessel_test.cpp.
#include "tests/coupling/vessel.h"

#include <gtest/gtest.h>

#include "tests/rigid_solvers.h"

namespace meniscus::tests {
namespace {

class VesselTest : public WithSolver {};

TEST_P(VesselTest, AClosedOneIsShakenAndSpunForThreeSeconds) {
  ShakenVessel vessel(GetParam());
  vessel.shake(3);
  EXPECT_EQ(vessel.crossings().count(), 0);
  EXPECT_EQ(vessel.crossings().lost(), 0);
  EXPECT_GT(vessel.furthest_in_radii(), 15);
  EXPECT_EQ(vessel.world().diagnostics().non_finite, 0u);
}

TEST_P(VesselTest, AnOpenOneIsCarriedForThreeSeconds) {
  CarriedCup cup(GetParam());
  cup.carry(3);
  EXPECT_EQ(cup.crossings().count(), 0);
  EXPECT_EQ(cup.crossings().lost(), 0);
}

// The count can tell: a wall that lets a fluid through is crossed.
TEST_P(VesselTest, WhatGetsThroughIsCounted) {
  World world(one_substep(GetParam(), 0.05f));
  const Vessel cup{{0.2f, 0.2f, 0.2f}, 0.025f, false};
  BodyDef sieve = kinematic(cup.geometry(), {0, 0, 0});
  sieve.filter.groups = 2;
  FluidDef water;
  water.filter.mask = 1;
  const BodyId id = world.create_body(sieve);
  const FluidId fluid = world.create_fluid(water);
  world.add_particles(fluid, std::vector<Vec3>{{0, -0.1f, 0}, {0.1f, 0.1f, 0.1f}});
  Crossings crossings(world, id, cup);
  for (int k = 0; k < 60; ++k) {
    world.step(0.01f);
    crossings.look(world);
  }
  EXPECT_EQ(crossings.count(), 2);
  EXPECT_EQ(crossings.lost(), 2);
}

MENISCUS_WITH_EACH_RIGID_SOLVER(VesselTest);

}  // namespace
}  // namespace meniscus::tests
