// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The marks of each triangle of cloth: its borders, and the vertices that it is the first to use.
#include "collision/fluid_cloth/marks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <random>
#include <set>

#include "pbd/contacts.h"

namespace meniscus::tests {
namespace {

using pbd::SurfaceTriangle;

constexpr uint32_t columns = 7, rows = 5;

/// A grid in a random order, with gaps where nothing stands.
std::vector<SurfaceTriangle> shuffled_grid() {
  std::vector<SurfaceTriangle> triangles(5, {pbd::no_index, pbd::no_index, pbd::no_index, 0});
  for (uint32_t r = 0; r + 1 < rows; ++r) {
    for (uint32_t c = 0; c + 1 < columns; ++c) {
      const uint32_t a = r * columns + c;
      triangles.push_back({a, a + columns, a + 1, 0});
      triangles.push_back({a + 1, a + columns, a + columns + 1, 0});
    }
  }
  std::shuffle(triangles.begin(), triangles.end(), std::mt19937(4));
  return triangles;
}

TEST(SheetMarks, NameEachVertexOnceAtTheFirstTriangleThatHasIt) {
  const std::vector<SurfaceTriangle> triangles = shuffled_grid();
  const std::vector<uint32_t> marks = collision::triangle_marks(triangles);
  std::set<uint32_t> seen;
  for (size_t t = 0; t < triangles.size(); ++t) {
    const uint32_t corner[] = {triangles[t].a, triangles[t].b, triangles[t].c};
    for (uint32_t k = 0; k < 3; ++k) {
      const bool is_new = corner[k] != pbd::no_index && seen.insert(corner[k]).second;
      EXPECT_EQ(marks[t] >> (collision::first_use_mark + k) & 1, is_new) << t << ", corner " << k;
    }
  }
  EXPECT_EQ(seen.size(), columns * rows);
}

TEST(SheetMarks, NameTheEdgesOfTheBorder) {
  const std::vector<SurfaceTriangle> triangles = shuffled_grid();
  const std::vector<uint32_t> marks = collision::triangle_marks(triangles);
  const auto on_border = [](uint32_t a, uint32_t b) {
    const uint32_t ca = a % columns, cb = b % columns, ra = a / columns, rb = b / columns;
    return (ca == cb && (ca == 0 || ca == columns - 1)) || (ra == rb && (ra == 0 || ra == rows - 1));
  };
  size_t edges = 0;
  for (size_t t = 0; t < triangles.size(); ++t) {
    const uint32_t corner[] = {triangles[t].a, triangles[t].b, triangles[t].c};
    for (uint32_t k = 0; k < 3 && corner[0] != pbd::no_index; ++k)
      EXPECT_EQ(marks[t] >> k & 1, on_border(corner[k], corner[(k + 1) % 3])) << t << ", edge " << k;
    edges += size_t(std::popcount(marks[t] & collision::border_marks));
  }
  EXPECT_EQ(edges, 2 * (columns - 1) + 2 * (rows - 1));
}

}  // namespace
}  // namespace meniscus::tests
