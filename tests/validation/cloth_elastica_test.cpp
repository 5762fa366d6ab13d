// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A strip that is clamped at one end bends under its own weight as a heavy elastica: with the load
// B = w L³/D, w its weight per area and D its bending stiffness, D θ'' = −w (L − s) cos θ.
#include "sdk/validation/cases/strips.h"
#include "tests/validation/cloth_worlds.h"

namespace meniscus::tests {
namespace {

struct Load {
  float load, drop;  // B, and the tip's drop over the length
};
constexpr Load loads[] = {{1, 0.1235f}, {2, 0.2385f}, {10, 0.7002f}, {20, 0.8299f}};

class ClothElastica : public OnDevice {
 protected:
  void expect_elastica(int squares, BendingModel model) {
    for (const Load& l : loads) {
      const double found = validation::strip_drop(world_def(GetParam(), 0.05f), l.load, squares, model);
      record("drop_at_" + std::to_string(int(l.load)), found);
      EXPECT_NEAR(found, l.drop, 0.05f * l.drop) << "B = " << l.load << ", " << squares << " squares";
    }
  }
};

TEST_P(ClothElastica, BendsAsItShould) {
  expect_elastica(10, BendingModel::isometric);
}
TEST_P(ClothElastica, BendsAsItShouldAtTwiceTheResolution) {
  expect_elastica(20, BendingModel::isometric);
}
TEST_P(ClothElastica, BendsAsItShouldByItsAngles) {
  expect_elastica(10, BendingModel::dihedral);
}
TEST_P(ClothElastica, BendsAsItShouldByItsAnglesAtTwiceTheResolution) {
  expect_elastica(20, BendingModel::dihedral);
}

MENISCUS_ON_EACH_DEVICE(ClothElastica);

}  // namespace
}  // namespace meniscus::tests
