// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A sheet on a slope holds up to atan μ, and slides beyond it as Coulomb has it.
#include "sdk/validation/cases/strips.h"
#include "tests/validation/cloth_worlds.h"

namespace meniscus::tests {
namespace {

class ClothFriction : public OnDevice {};

TEST_P(ClothFriction, HoldsBelowTheAngleOfFrictionAndSlidesAboveIt) {
  for (float friction : {0.2f, 0.5f, 0.8f}) {
    const float critical = std::atan(friction);
    for (float beyond : {-2.0f, 2.0f}) {
      const float degrees = critical * 180 / 3.14159265f + beyond;
      const double moved = validation::slide(world_def(GetParam(), 0.05f), friction, degrees);
      record("moved_at_" + std::to_string(friction) + "_by_" + std::to_string(int(beyond)), moved);
      if (beyond < 0) {
        EXPECT_LT(moved, 1e-4) << "friction " << friction;
      } else {
        const double expected = validation::exact_slide(friction, degrees);
        EXPECT_NEAR(moved, expected, 0.2 * expected) << "friction " << friction;
      }
    }
  }
}

MENISCUS_ON_EACH_DEVICE(ClothFriction);

}  // namespace
}  // namespace meniscus::tests
