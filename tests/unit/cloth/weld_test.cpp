// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Vertices of cloth within a distance are merged, whatever their order.
#include "cloth/build/weld.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <tuple>

namespace meniscus::cloth {
namespace {

/// A sheet of 12 × 11 vertices with edges of 0.1 m, whose seam between columns 5 and 6 is so wide.
ClothMesh with_seam(float width) {
  ClothMesh mesh = make_sheet(1.1f, 1, 12, 11);
  mesh.material.clear();
  for (uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    if (v % 12 > 5) mesh.vertices[v].x += width - 0.1f;
    if (v % 12 == 6) mesh.vertices[v].x = mesh.vertices[v - 1].x + width;
  }
  return mesh;
}

std::vector<std::tuple<float, float, float>> sorted_positions(const ClothMesh& mesh) {
  std::vector<std::tuple<float, float, float>> at;
  for (Vec3 x : mesh.vertices) at.emplace_back(x.x, x.y, x.z);
  std::sort(at.begin(), at.end());
  return at;
}

TEST(Weld, ASeamIsClosed) {
  ClothMesh mesh = with_seam(4e-6f);
  EXPECT_ANY_THROW(check_mesh(mesh));
  EXPECT_EQ(weld(mesh, 1e-5), 11u);
  EXPECT_EQ(mesh.vertices.size(), 121u);
  EXPECT_EQ(mesh.triangles.size(), 200u);
  check_mesh(mesh);
}

TEST(Weld, WiderSeamsStay) {
  ClothMesh mesh = with_seam(1e-3f);
  EXPECT_EQ(weld(mesh, 1e-5), 0u);
  EXPECT_EQ(weld(mesh, 0), 0u);
  EXPECT_EQ(mesh.triangles.size(), 220u);
}

TEST(Weld, TheShapeDoesNotDependOnTheOrder) {
  ClothMesh mesh = with_seam(4e-6f), shuffled = mesh;
  std::vector<uint32_t> number(mesh.vertices.size());
  std::iota(number.begin(), number.end(), 0u);
  std::shuffle(number.begin(), number.end(), std::mt19937(3));
  for (uint32_t v = 0; v < number.size(); ++v) shuffled.vertices[number[v]] = mesh.vertices[v];
  for (auto& t : shuffled.triangles) t = {number[t[0]], number[t[1]], number[t[2]]};
  EXPECT_EQ(weld(mesh, 1e-5), weld(shuffled, 1e-5));
  EXPECT_EQ(sorted_positions(mesh), sorted_positions(shuffled));
  EXPECT_EQ(mesh.triangles.size(), shuffled.triangles.size());
}

TEST(Weld, PairsInARowBecomeOne) {
  ClothMesh mesh{{{2e-5f, 0, 0}, {0, 0, 0}, {1e-5f, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{1, 3, 4}, {0, 2, 3}}, {}};
  EXPECT_EQ(weld(mesh, 1.2e-5), 2u);
  ASSERT_EQ(mesh.vertices.size(), 3u);
  EXPECT_EQ(mesh.vertices[0].x, 0);
  EXPECT_EQ(mesh.triangles.size(), 1u);
}

}  // namespace
}  // namespace meniscus::cloth
