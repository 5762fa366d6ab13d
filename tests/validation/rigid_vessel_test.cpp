// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A minute in a container: no particle gets through its walls.
#include "tests/coupling/vessel.h"
#include "tests/validation/measures.h"

namespace meniscus::tests {
namespace {

class RigidVesselTest : public OnDevice {};

TEST_P(RigidVesselTest, NothingLeavesAClosedOneThatIsShakenAndSpun) {
  ShakenVessel vessel(GetParam());
  const size_t count = vessel.world().particle_count();
  vessel.shake(60);
  record("furthest_motion_radii", vessel.furthest_in_radii());
  record("crossings", vessel.crossings().count());
  EXPECT_GE(vessel.furthest_in_radii(), 20);
  EXPECT_EQ(vessel.crossings().count(), 0);
  EXPECT_EQ(vessel.crossings().lost(), 0);
  EXPECT_EQ(vessel.world().particle_count(), count);
}

TEST_P(RigidVesselTest, NothingIsSpiltFromAnOpenOneThatIsCarried) {
  CarriedCup cup(GetParam());
  const size_t count = cup.world().particle_count();
  cup.carry(60);
  record("crossings", cup.crossings().count());
  EXPECT_EQ(cup.crossings().count(), 0);
  EXPECT_EQ(cup.crossings().lost(), 0);
  EXPECT_EQ(cup.world().particle_count(), count);
}

MENISCUS_ON_EACH_DEVICE(RigidVesselTest);

}  // namespace
}  // namespace meniscus::tests
