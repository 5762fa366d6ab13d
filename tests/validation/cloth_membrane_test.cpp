// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Water on both sides of a taut sheet that parts a tank, held along its top and its bottom: with levels alike
// it stays flat; else it bulges as a membrane does, T w'' = −Δp, with the tension T that its stretch gives.
#include "sdk/validation/cases/parted_tank.h"
#include "tests/validation/cloth_worlds.h"

namespace meniscus::tests {
namespace {

using validation::exact_bulge;
using validation::largest;
using validation::largest_difference;
using validation::PartedTank;

class ClothMembrane : public OnDevice {};

TEST_P(ClothMembrane, StaysFlatBetweenEqualLevels) {
  PartedTank tank(world_def(GetParam(), 1), 0.25f, 0.25f);
  const double off = largest(tank.bulge_at_rest());
  record("off_flat_percent", 100 * off / double{PartedTank::height});
  EXPECT_LT(off, 0.005 * double{PartedTank::height});
}

TEST_P(ClothMembrane, BulgesWithTheDifferenceOfLevels) {
  for (const float right : {0.0f, 0.15f}) {
    PartedTank tank(world_def(GetParam(), 1), 0.35f, right);
    const std::vector<double> measured = tank.bulge_at_rest();
    const std::vector<double> theory = exact_bulge(tank.volume);
    const double worst = largest_difference(measured, theory);
    const std::string name = right > 0 ? "_over_water" : "_over_air";
    record("bulge" + name, largest(theory));
    record("bulge_error_percent" + name, 100 * (largest(measured) / largest(theory) - 1));
    record("shape_error_percent" + name, 100 * worst / largest(theory));
    EXPECT_GT(largest(theory), 0.03 * double{PartedTank::height});
    EXPECT_LT(worst, 0.1 * largest(theory)) << name;
  }
}

MENISCUS_ON_EACH_DEVICE(ClothMembrane);

}  // namespace
}  // namespace meniscus::tests
