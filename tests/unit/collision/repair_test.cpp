// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the repair of meshes, and of reports on mesh files.
#include "collision/sdf/repair.h"

#include <gtest/gtest.h>
#include <meniscus/error.h>

#include <filesystem>
#include <fstream>
#include <numbers>

#include "collision/mesh/defects.h"
#include "collision/mesh/inspect.h"
#include "tests/unit/collision/mesh_shapes.h"
#include "tests/unit/collision/turned_shapes.h"

namespace meniscus::collision {
namespace {

TriangleMesh both(TriangleMesh a, const TriangleMesh& b) {
  const auto first = static_cast<uint32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& t : b.triangles) a.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return a;
}

/// Signed distance to an axis-aligned box.
float box_distance(Vec3 p, Vec3 lower, Vec3 upper) {
  const Vec3 out = max(max(lower - p, p - upper), {0, 0, 0});
  const float inside =
      -std::min({p.x - lower.x, p.y - lower.y, p.z - lower.z, upper.x - p.x, upper.y - p.y, upper.z - p.z});
  return inside > 0 ? length(out) : inside;
}

TEST(RepairMesh, OverlappingBoxesBecomeTheirUnion) {
  const TriangleMesh crossing =
      both(box_mesh({0, 0, 0}, {1, 1, 1}), box_mesh({0.4f, 0.5f, 0.3f}, {1.6f, 1.5f, 0.8f}));
  ASSERT_FALSE(find_defects(crossing).self_intersections.empty());
  const RepairedMesh repaired = repair_mesh(crossing, 0.04f, "it");
  EXPECT_TRUE(find_defects(repaired.mesh).none());
  const double volume = 1 + 1.2 * 1.0 * 0.5 - 0.6 * 0.5 * 0.5;
  EXPECT_NEAR(repaired.volume, volume, 0.02 * volume);
  EXPECT_NEAR(repaired.volume_before, volume, 0.02 * volume);
  EXPECT_LE(repaired.deviation, repaired.cell_size);
  EXPECT_EQ(repaired.cell_size, 0.04f);
  float furthest = 0;
  for (const Vec3 v : repaired.mesh.vertices) {
    furthest =
        std::max(furthest, std::fabs(std::min(box_distance(v, {0, 0, 0}, {1, 1, 1}),
                                              box_distance(v, {0.4f, 0.5f, 0.3f}, {1.6f, 1.5f, 0.8f}))));
  }
  EXPECT_LE(furthest, repaired.cell_size);
}

TEST(RepairMesh, HolesAreClosed) {
  const float cell = 0.02f;
  // Without its top, which is a cap of a twentieth of the diameter.
  const RepairedMesh repaired = repair_mesh(open_ball_mesh(0.5f, 5, 0.47f), cell, "it");
  EXPECT_TRUE(find_defects(repaired.mesh).none());
  const double volume = std::numbers::pi / 6;
  EXPECT_NEAR(repaired.volume, volume, 0.02 * volume);
  EXPECT_LE(repaired.deviation, repaired.cell_size);
}

TEST(RepairMesh, ACoarseGridIsRefinedUntilNothingIsLost) {
  // A plate of a tenth of a cell on a box.
  const TriangleMesh mesh =
      both(box_mesh({0, 0, 0}, {1, 1, 1}), box_mesh({-0.5f, 0.5f, 0.2f}, {0.1f, 0.53f, 0.8f}));
  const RepairedMesh repaired = repair_mesh(mesh, 0.25f, "it");
  EXPECT_EQ(repaired.cell_size, 0.25f);
  EXPECT_LE(repaired.deviation, 0.25f) << "the plate is twice as long";
  EXPECT_TRUE(find_defects(repaired.mesh).none());
}

TEST(RepairMesh, SharpTipsAreKept) {
  // A pyramid without its base, five times as high as it is wide. Its tip loses four cells of each grid.
  const TriangleMesh spike{{{0, 0, 0}, {0.2f, 0, 0}, {0.2f, 0, 0.2f}, {0, 0, 0.2f}, {0.1f, 1, 0.1f}},
                           {{0, 4, 1}, {1, 4, 2}, {2, 4, 3}, {3, 4, 0}}};
  const RepairedMesh repaired = repair_mesh(spike, 1.0f / 64, "it");
  EXPECT_TRUE(find_defects(repaired.mesh).none());
  EXPECT_LE(repaired.deviation, 1.0f / 64);
  EXPECT_NEAR(repaired.volume, 0.2 * 0.2 / 3, 0.02 * 0.2 * 0.2 / 3);
}

TEST(RepairMesh, WallsThinnerThanTheFinestCellsAreRefused) {
  const TriangleMesh mesh =
      both(box_mesh({0, 0, 0}, {1, 1, 1}), box_mesh({-0.5f, 0.50001f, 0.2f}, {0.1f, 0.50011f, 0.8f}));
  try {
    repair_mesh(mesh, 0.014f, "mesh file 'x'");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::mesh);
    EXPECT_NE(std::string(error.what()).find("mesh file 'x' cannot be repaired: a wall is thinner"),
              std::string::npos)
        << error.what();
  }
}

TEST(RepairMesh, ASheetHasNoInside) {
  TriangleMesh sheet{{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}, {{0, 1, 2}, {0, 2, 3}}};
  EXPECT_THROW(repair_mesh(sheet, 0.05f, "it"), Error);
}

TEST(InspectMesh, CountsWhatIsWrong) {
  const std::string path = (std::filesystem::path(testing::TempDir()) / "meniscus_inspected.obj").string();
  TriangleMesh mesh =
      both(box_mesh({0, 0, 0}, {1, 1, 1}), box_mesh({0.5f, 0.25f, 0.25f}, {1.5f, 0.75f, 0.75f}));
  mesh.triangles.erase(mesh.triangles.begin());  // two holes, in opposite faces
  mesh.triangles.erase(mesh.triangles.begin() + 2);
  mesh.vertices.push_back({2e-7f, 0, 0});  // a second corner in almost the same place
  mesh.triangles.push_back({16, 1, 16});   // without area
  std::ofstream(path) << obj_of(mesh);
  const MeshReport report = inspect_mesh(path, 2);
  EXPECT_EQ(report.box.upper.x, 3);
  EXPECT_EQ(report.triangles, 22u);
  EXPECT_EQ(report.holes, 2u);
  EXPECT_EQ(report.open_edges, 6u);
  EXPECT_EQ(report.odd_edges, 0u);
  EXPECT_GT(report.crossings, 0u);
  EXPECT_EQ(report.welded, 1u);
  std::filesystem::remove(path);
}

TEST(InspectMesh, GuessesUnits) {
  EXPECT_STREQ(unit_guess(0.3f), "metres");
  EXPECT_STREQ(unit_guess(180), "centimetres");
  EXPECT_STREQ(unit_guess(9000), "millimetres");
  EXPECT_STREQ(unit_guess(1e6f), "unknown");
}

}  // namespace
}  // namespace meniscus::collision
