// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the grid of the neighbour search.
#include "pbd/grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <vector>

namespace meniscus::pbd {
namespace {

GridView grid(float reach, uint32_t bits_x, uint32_t bits_y, uint32_t bits_z, uint32_t strip_bits = 0) {
  GridView g;
  g.inverse_reach = 1 / reach;
  g.bits_x = bits_x;
  g.bits_y = bits_y;
  g.bits_z = bits_z;
  g.strip_bits = strip_bits;
  return g;
}

TEST(Grid, CoordinatesRoundDownOnBothSidesOfTheOrigin) {
  const GridView g = grid(0.5f, 4, 4, 4);
  const CellCoordinates c = g.coordinates({-0.1f, 0.1f, -0.6f});
  EXPECT_EQ(c.x, -1);  // a slice
  EXPECT_EQ(c.y, 0);
  EXPECT_EQ(c.z, -2);
}

TEST(Grid, AnyFloatHasACell) {
  const GridView g = grid(0.1f, 4, 4, 4);
  const float inf = std::numeric_limits<float>::infinity();
  for (float x : {1e30f, -1e30f, inf, -inf, std::numeric_limits<float>::quiet_NaN(), 3e38f}) {
    EXPECT_LT(g.key(g.coordinates({x, -x, x})), 1u << g.key_bits());
  }
}

TEST(Grid, KeysStayInTheTableAndDifferAcrossOneTable) {
  for (uint32_t strip_bits : {0, 1, 2}) {
    const GridView g = grid(1, 3, 2, 4, strip_bits);
    for (int offset : {0, -5, -1000000, 99999999}) {
      std::set<uint32_t> keys;
      for (int x = 0; x < 8; ++x) {
        for (int y = 0; y < 4; ++y) {
          for (int z = 0; z < 16; ++z) keys.insert(g.key({x + offset, y - offset, z + offset}));
        }
      }
      EXPECT_EQ(keys.size(), 512u);
      EXPECT_LT(*keys.rbegin(), 512u);
    }
  }
}

TEST(Grid, RowsAndLayersOfAStripFollowOneAnother) {
  const GridView g = grid(1, 3, 4, 4, 2);
  EXPECT_EQ(g.row(5, 7), g.row(4, 7) + (1u << 3));
  EXPECT_EQ(g.row(4, 8), g.row(4, 7) + (1u << (3 + 2)));
  EXPECT_EQ(g.row(8, 7), g.row(4, 7) + (1u << (3 + 2 + 4)));
}

TEST(Grid, CellsThatShareAnEntryAreAWholeTableApart) {
  const GridView g = grid(1, 3, 2, 4);
  EXPECT_EQ(g.key({-3, 1, 7}), g.key({5, 1, 7}));
  EXPECT_EQ(g.key({-3, 1, 7}), g.key({-3, -3, 7}));
  EXPECT_EQ(g.key({-3, 1, 7}), g.key({-3, 1, -9}));
}

// Of a table with one particle a cell: the cells that the runs around p hold.
std::multiset<uint32_t> visited(GridView g, Vec3 p) {
  std::vector<uint32_t> start(g.cell_count() + 1);
  std::iota(start.begin(), start.end(), 0u);
  g.start = {start.data(), static_cast<uint32_t>(start.size())};
  std::multiset<uint32_t> cells;
  RunsAround(g, p).for_each([&](uint32_t begin, uint32_t end) {
    for (uint32_t i = begin; i < end; ++i) cells.insert(i);
  });
  return cells;
}

TEST(Grid, RunsKnowHowFarTheirIndicesAre) {
  GridView g = grid(1, 6, 4, 4, 4);
  std::vector<uint32_t> start(g.cell_count() + 1);
  std::iota(start.begin(), start.end(), 0u);
  g.start = {start.data(), static_cast<uint32_t>(start.size())};
  const Vec3 p{8.5f, 8.5f, 8.5f};
  const uint32_t i = g.key(g.coordinates(p));
  const RunsAround runs(g, p);
  uint32_t furthest = 0;
  runs.for_each([&](uint32_t begin, uint32_t end) {
    if (begin < end) furthest = std::max({furthest, i > begin ? i - begin : 0, end > i ? end - i : 0});
  });
  EXPECT_TRUE(runs.are_within(furthest, i));
  EXPECT_FALSE(runs.are_within(furthest - 1, i));
}

class GridAround : public testing::Test {
 protected:
  std::mt19937 random_{5};

  float from_to(float lower, float upper) {
    return std::uniform_real_distribution<float>(lower, upper)(random_);
  }
  Vec3 in_cube(float half) { return {from_to(-half, half), from_to(-half, half), from_to(-half, half)}; }
  Vec3 in_ball(float radius) {
    for (;;) {
      const Vec3 d = in_cube(radius);
      if (length(d) < radius) return d;
    }
  }
};

TEST_F(GridAround, RunsHoldTheCellsOfAllThatIsWithinReachOnce) {
  for (const GridView& g : {grid(0.1f, 4, 2, 2), grid(0.1f, 4, 3, 2, 1), grid(0.1f, 6, 4, 5, 2)}) {
    for (float far : {1.0f, 100.0f, 1e4f, 3e5f}) {
      for (int n = 0; n < 50; ++n) {
        const Vec3 p = in_cube(far);
        const std::multiset<uint32_t> cells = visited(g, p);
        for (uint32_t cell : cells) ASSERT_EQ(cells.count(cell), 1u);
        for (int k = 0; k < 100; ++k) {
          const Vec3 q = p + in_ball(0.1f);
          if (length(q - p) >= 0.1f) continue;  // rounded out of reach
          ASSERT_EQ(cells.count(g.key(g.coordinates(q))), 1u) << n << ", " << far << " m away";
        }
      }
    }
  }
}

TEST_F(GridAround, RunsHoldLittleElse) {
  const GridView g = grid(0.1f, 6, 4, 4);
  size_t cells = 0;
  for (int n = 0; n < 1000; ++n) cells += visited(g, in_cube(1)).size();
  // On average rows of 2, π/2 or π/6 · 2 reaches, and a cell more each; 27 whole cells have 108 slices.
  const double expected = GridView::slices * (2 + 4 * 1.571 + 4 * 1.047) + 9;
  EXPECT_LT(static_cast<double>(cells) / 1000, 1.05 * expected);
}

TEST_F(GridAround, PointsTooFarAwayForTheGridHaveRunsAsWell) {
  const GridView g = grid(0.1f, 4, 2, 2);
  for (float far : {1e7f, 1e12f, 3e38f}) {
    const std::multiset<uint32_t> cells = visited(g, {far, -far, far});
    EXPECT_EQ(cells.count(g.key(g.coordinates({far, -far, far}))), 1u);
    for (uint32_t cell : cells) ASSERT_EQ(cells.count(cell), 1u);
  }
}

}  // namespace
}  // namespace meniscus::pbd
