// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A strip that is clamped at one end bends under its own weight as a heavy elastica: with the load
// B = w L³/D, w its weight per area and D its bending stiffness, D θ'' = −w (L − s) cos θ.
#include "tests/validation/cloth_worlds.h"

namespace meniscus::tests {
namespace {

struct Load {
  float load, drop;  // B, and the tip's drop over the length
};
constexpr Load loads[] = {{1, 0.1235f}, {2, 0.2385f}, {10, 0.7002f}, {20, 0.8299f}};

/// A strip 1 m long beyond its clamp, which is in the middle of the one column of squares that is held. It is
/// wide enough not to turn up its edges (a narrow one bends across as well), and without damping, which slows
/// the convergence of bending. Substeps go with the square of a square's side: as α̃/w does.
class ClothElastica : public OnDevice {
 protected:
  float drop(float load, int squares, BendingModel model) {
    const float side = 1 / (float(squares) + 0.5f);
    const int rows = squares == 10 ? 7 : 9;
    World world(cloth_world(GetParam(), 40 * squares * squares / 100, 2));
    ClothDef def = sheet(float(squares + 1) * side, float(rows - 1) * side, squares + 2, rows);
    def.self_collision = def.tethers = false;
    def.fabric.bending_model = model;
    def.fabric.bending_stiffness = def.fabric.density * 9.81f / load;
    def.fabric.bending_damping = def.fabric.lift = 0;
    const ClothId id = world.create_cloth(def);
    world.create_attachment(attach(id, column_of(def, 0) + column_of(def, 1)));
    world.set_wind({.air_density = 20});
    run(world, 480, frame);
    return -mean_of(world.cloth_positions(id), column_of(def, squares + 1)).y;
  }

  void expect_elastica(int squares, BendingModel model) {
    for (const Load& l : loads) {
      const float found = drop(l.load, squares, model);
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
