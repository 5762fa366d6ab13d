// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cloth that hangs stretches as little as it should, and the same whatever the number of substeps.
#include "tests/validation/cloth_worlds.h"

namespace meniscus::tests {
namespace {

class ClothHanging : public OnDevice {
 protected:
  struct Sheet {
    double length, p99, force;  // over those at rest, and over the weight
  };

  /// A sheet of cotton, 1 m by 1 m, falls from level and swings about an edge for 10 s.
  Sheet hang(int substeps, bool tethers) {
    World world(cloth_world(GetParam(), substeps, 1));
    ClothDef def = sheet(1, 1, 50, 50);
    def.fabric.density = 0.15f;
    def.tethers = tethers;
    const ClothId id = world.create_cloth(def);
    const AttachmentId rail = world.create_attachment(attach(id, vertices_from(0, 50)));
    run(world, 600, frame);
    float lowest = 0;
    for (Vec3 x : world.cloth_positions(id)) lowest = std::min(lowest, x.y);
    const double weight = double{world.cloth_state(id).mass} * 9.81;
    const Sheet found{double{-lowest}, percentile(edge_stretches(world, id, at_rest(def)), 0.99),
                      -double{world.attachment_force(rail).y} / weight};
    record("length", found.length);
    record("p99_stretch", found.p99);
    record("force_over_weight", found.force);
    return found;
  }

  /// How far a sheet hangs through between two edges that are nearer than it is long.
  float sag(int substeps, StretchModel model) {
    World world(cloth_world(GetParam(), substeps, 20));
    ClothDef def = sheet(1, 0.5f, 21, 11);
    def.stretch = {0.9f, 1, 1};
    def.tethers = def.self_collision = false;
    def.fabric.stretch_model = model;
    const ClothId id = world.create_cloth(def);
    world.create_attachment(attach(id, column_of(def, 0) + column_of(def, 20)));
    settle(world, 4);
    return -mean_of(world.cloth_positions(id), column_of(def, 10)).y;
  }

  void expect_one_sag(StretchModel model) {
    const float finest = sag(40, model);
    record("sag_at_40", finest);
    for (int substeps : {5, 10, 20}) {
      const float found = sag(substeps, model);
      record("sag_at_" + std::to_string(substeps), found);
      EXPECT_NEAR(found, finest, 0.01f * finest) << substeps << " substeps";
    }
  }
};

TEST_P(ClothHanging, ByTethersASheetKeepsItsLength) {
  const Sheet found = hang(16, true);
  EXPECT_LE(found.length, 1.005);
  EXPECT_LE(found.p99, 1.01);
  EXPECT_NEAR(found.force, 1, 0.2);  // it still swings
}

TEST_P(ClothHanging, WithoutTethersAsWell) {
  const Sheet found = hang(16, false);
  EXPECT_LE(found.length, 1.005);
  EXPECT_LE(found.p99, 1.01);
  EXPECT_NEAR(found.force, 1, 0.2);
}

// What a sweep leaves of a column grows with the square of its rows and of the substep.
TEST_P(ClothHanging, AFineSheetInLongSubstepsAsWell) {
  World world(cloth_world(GetParam(), 2, 1));
  ClothDef def = sheet(2, 2, 160, 160);
  def.fabric.density = 0.2f;
  def.tethers = def.self_collision = false;
  const ClothId id = world.create_cloth(def);
  world.create_attachment(attach(id, vertices_from(0, 160)));
  run(world, 150, frame);
  const double p99 = percentile(edge_stretches(world, id, at_rest(def)), 0.99);
  record("p99_stretch", p99);
  EXPECT_LE(p99, 1.02);
}

TEST_P(ClothHanging, SagDoesNotDependOnSubsteps) {
  expect_one_sag(StretchModel::edges);
}
TEST_P(ClothHanging, NorDoesItByTriangles) {
  expect_one_sag(StretchModel::triangles);
}

MENISCUS_ON_EACH_DEVICE(ClothHanging);

}  // namespace
}  // namespace meniscus::tests
