// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of cloth meshes: sheets, checks and orientation.
#include "cloth/build/cloth_mesh.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "cloth/build/topology.h"
#include "tests/expect_error.h"
#include "tests/unit/cloth/cloth_shapes.h"
#include "tests/unit/moebius_strip.h"

namespace meniscus::cloth {
namespace {

using tests::expect_error;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

bool agrees_everywhere(const ClothMesh& mesh) {
  bool agrees = true;
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    agrees = agrees && (edge.size() < 2 || edge[0].forward != edge[1].forward);
  });
  return agrees;
}

std::vector<uint32_t> edges_at_vertices(const ClothMesh& mesh) {
  std::vector<uint32_t> count(mesh.vertices.size(), 0);
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    ++count[edge[0].low];
    ++count[edge[0].high];
  });
  return count;
}

TEST(ClothMesh, ASheetIsFlatCentredAndFacesUp) {
  const ClothMesh sheet = make_sheet(2, 1, 5, 3);
  check_mesh(sheet);
  ASSERT_EQ(sheet.vertices.size(), 15u);
  EXPECT_EQ(sheet.triangles.size(), 16u);
  EXPECT_TRUE(sheet.vertices[0] == (Vec3{-1, 0, -0.5f}));
  EXPECT_TRUE(sheet.vertices[9] == (Vec3{1, 0, 0}));  // column 4, row 1
  EXPECT_EQ(sheet.material[9], (std::array{2.0f, 0.5f}));
  EXPECT_NEAR(area_of(sheet), 2, 1e-6);
  for (const auto& [a, b, c] : sheet.triangles) {
    EXPECT_GT(cross(sheet.vertices[b] - sheet.vertices[a], sheet.vertices[c] - sheet.vertices[a]).y, 0);
  }
}

TEST(ClothMesh, InnerVerticesOfASheetHaveSixEdges) {
  const ClothMesh sheet = make_sheet(1, 1, 7, 6);
  const std::vector<uint32_t> edges = edges_at_vertices(sheet);
  for (uint32_t j = 1; j < 5; ++j) {
    for (uint32_t i = 1; i < 6; ++i) EXPECT_EQ(edges[j * 7 + i], 6u) << i << ", " << j;
  }
}

TEST(ClothMesh, ASheetHasAsManyDiagonalsOfEitherDirection) {
  const ClothMesh sheet = make_sheet(1, 1, 9, 9);
  int rising = 0, falling = 0;
  const std::vector<EdgeUse> uses = edge_uses(sheet);
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    const Vec3 way = sheet.vertices[edge[0].high] - sheet.vertices[edge[0].low];
    rising += way.x * way.z > 1e-4f;
    falling += way.x * way.z < -1e-4f;
  });
  EXPECT_EQ(rising, 32);
  EXPECT_EQ(falling, 32);
}

TEST(ClothMesh, ACheckNamesTheFault) {
  const ClothMesh good = make_sheet(1, 1, 3, 3);
  const auto refused = [&](const char* named, auto&& spoil) {
    ClothMesh mesh = good;
    spoil(mesh);
    expect_error(ErrorCode::mesh, named, [&] { check_mesh(mesh); });
  };
  refused("no triangles", [](ClothMesh& m) { m.triangles.clear(); });
  refused("triangle 3 of", [](ClothMesh& m) { m.triangles[3][1] = 9; });
  refused("vertex 4 of a cloth mesh is not finite", [](ClothMesh& m) { m.vertices[4].y = nan; });
  refused("vertex 9 of a cloth mesh is in no triangle", [](ClothMesh& m) {
    m.vertices.push_back({0, 0, 0});
    m.material.push_back({0, 0});
  });
  refused("triangle 2 of a cloth mesh has no area",
          [](ClothMesh& m) { m.triangles[2][0] = m.triangles[2][1]; });
  refused("has no area", [](ClothMesh& m) {
    const auto& [a, b, c] = m.triangles[5];
    m.vertices[a] = 0.5f * (m.vertices[b] + m.vertices[c]);
  });
  refused("the triangles 0 and 1", [](ClothMesh& m) {
    m = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {2, 1, 0}}, {}};
  });
  refused("has 3 triangles", [](ClothMesh& m) {
    m = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, {}};
  });
  refused("material", [](ClothMesh& m) { m.material.pop_back(); });
  refused("material coordinates of vertex 7", [](ClothMesh& m) { m.material[7][1] = nan; });
  refused("lie on a line", [](ClothMesh& m) {
    for (auto& uv : m.material) uv[1] = 2 * uv[0];
  });
  check_mesh(good);
}

TEST(ClothMesh, NarrowTrianglesAreTaken) {
  ClothMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0.5f, 1e-3f, 0}}, {{0, 1, 2}}, {}};
  check_mesh(mesh);
  mesh.vertices[2].y = 1e-7f;
  expect_error(ErrorCode::mesh, "triangle 0 of a cloth mesh has no area", [&] { check_mesh(mesh); });
}

TEST(ClothMesh, AThinTriangleIsRefusedByItsEdge) {
  // A seam 4 µm wide between triangles of 0.1 m.
  ClothMesh mesh{{{0.1f, 0, 0.1f}, {0, 0, 0}, {0, 0, 0.1f}, {4e-6f, 0, 0}}, {{2, 3, 0}, {1, 3, 2}}, {}};
  expect_error(ErrorCode::mesh, "triangle 1 of a cloth mesh is 4e-06 m high over an edge of 0.1 m",
               [&] { check_mesh(mesh); });
  expect_error(ErrorCode::mesh, "shortest edge, between the vertices 1 and 3, is 4e-06 m long",
               [&] { check_mesh(mesh); });
  mesh.vertices[3].x = 1e-4f;
  check_mesh(mesh);
  // A cap is as thin, without a short edge.
  mesh = {{{0, 0, 0}, {1, 0, 0}, {0.5f, 1e-5f, 0}}, {{0, 1, 2}}, {}};
  expect_error(ErrorCode::mesh, "triangle 0 of a cloth mesh is 1e-05 m high", [&] { check_mesh(mesh); });
}

TEST(ClothMesh, OrientingMakesNeighboursAgree) {
  const ClothMesh sheet = make_sheet(1, 1, 20, 20);
  ClothMesh muddled = sheet;
  std::mt19937 bits(5);
  for (size_t t = 1; t < muddled.triangles.size(); ++t) {
    if (bits() % 3 == 0) std::swap(muddled.triangles[t][1], muddled.triangles[t][2]);
  }
  ASSERT_FALSE(agrees_everywhere(muddled));
  orient_triangles(muddled);
  EXPECT_EQ(muddled.triangles, sheet.triangles);  // the first one had kept its side
}

TEST(ClothMesh, AStripWithOneSideIsLeftWithOneSeam) {
  ClothMesh mesh = tests::moebius_strip<ClothMesh>();
  orient_triangles(mesh);
  check_mesh(mesh);
  int disagreeing = 0;
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    disagreeing += edge.size() == 2 && edge[0].forward == edge[1].forward;
  });
  EXPECT_EQ(disagreeing, 1);
  EXPECT_FALSE(is_closed(mesh));
}

TEST(ClothMesh, ClosedIsWhatHasNoBorder) {
  ClothMesh mesh = octahedron();
  EXPECT_TRUE(is_closed(mesh));
  std::swap(mesh.triangles[4][0], mesh.triangles[4][1]);
  EXPECT_FALSE(is_closed(mesh));
  orient_triangles(mesh);
  EXPECT_TRUE(is_closed(mesh));
  mesh.triangles.pop_back();
  EXPECT_FALSE(is_closed(mesh));
  EXPECT_FALSE(is_closed(make_sheet(1, 1, 4, 4)));
  EXPECT_FALSE(is_closed({}));
}

TEST(ClothMesh, PartsAreNumberedByTheirFirstVertex) {
  ClothMesh mesh;
  mesh.vertices.resize(7);
  mesh.triangles = {{6, 4, 2}, {0, 3, 5}};
  EXPECT_EQ(connected_parts(mesh), (std::vector<uint32_t>{0, 1, 2, 0, 2, 0, 2}));
  const ClothMesh sheet = shuffled(make_sheet(1, 1, 30, 30), 3);
  EXPECT_EQ(connected_parts(sheet), std::vector<uint32_t>(900, 0));
}

}  // namespace
}  // namespace meniscus::cloth
