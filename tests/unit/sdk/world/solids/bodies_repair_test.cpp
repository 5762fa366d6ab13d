// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Bodies and shapes of meshes that are repaired on request.
#include <gtest/gtest.h>

#include "tests/unit/sdk/world/solids/body_worlds.h"

namespace meniscus::tests {
namespace {

class BodyRepairTest : public testing::Test {
 protected:
  TemporaryFolder folder_;
  World world_{world_def(pbd::DeviceKind::cpu, 0.5f)};

  MeshGeometry mesh(const char* text) const {
    MeshGeometry geometry{folder_.write("it.obj", text)};
    geometry.repair = true;
    return geometry;
  }
};

TEST_F(BodyRepairTest, AnOpenMeshFallsAsTheClosedOne) {
  MeshGeometry open = mesh(open_brick_obj);
  open.repair = false;
  expect_error(ErrorCode::mesh, "repair", [&] { world_.create_body(body(open)); });
  EXPECT_TRUE(world_.mesh_repairs().empty());
  open.repair = true;
  const BodyMass mass = world_.body_mass(world_.create_body(body(open)));
  EXPECT_NEAR(mass.volume, 6, 0.02 * 6);
  ASSERT_EQ(world_.mesh_repairs().size(), 1u);
  const MeshRepair& repair = world_.mesh_repairs()[0];
  EXPECT_EQ(repair.file, open.file);
  EXPECT_EQ(repair.open_edges, 4u);
  EXPECT_NEAR(repair.volume, mass.volume, 1e-3 * repair.volume);
  EXPECT_NEAR(repair.volume / repair.volume_before, 1, 0.02);
  EXPECT_GT(repair.cell_size, 0);
  EXPECT_LE(repair.deviation, repair.cell_size);
}

TEST_F(BodyRepairTest, AGoodMeshStaysAsItIs) {
  const BodyMass mass = world_.body_mass(world_.create_body(body(mesh(brick_obj))));
  EXPECT_NEAR(mass.volume, 6, 1e-5);
  EXPECT_TRUE(world_.mesh_repairs().empty());
}

TEST_F(BodyRepairTest, EqualMeshesAreRepairedOnce) {
  const MeshGeometry open = mesh(open_brick_obj);
  const BodyId first = world_.create_body(body(open));
  const BodyId second = world_.create_body(body(open, {5, 0, 0}));
  EXPECT_EQ(world_.body_mass(first).mass, world_.body_mass(second).mass);
  EXPECT_EQ(world_.mesh_repairs().size(), 2u);
}

}  // namespace
}  // namespace meniscus::tests
