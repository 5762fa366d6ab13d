// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "pbd/grid.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <vector>

namespace meniscus::pbd {
namespace {

GridView grid(float cell, uint32_t bits_x, uint32_t bits_y, uint32_t bits_z) {
  GridView g;
  g.inverse_cell = 1 / cell;
  g.bits_x = bits_x;
  g.bits_y = bits_y;
  g.bits_z = bits_z;
  return g;
}

TEST(Grid, CoordinatesRoundDownOnBothSidesOfTheOrigin) {
  const GridView g = grid(0.5f, 4, 4, 4);
  const CellCoordinates c = g.coordinates({-0.1f, 0.1f, -0.6f});
  EXPECT_EQ(c.x, -1);
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
  const GridView g = grid(1, 3, 2, 4);
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

TEST(Grid, CellsThatShareAnEntryAreAWholeTableApart) {
  const GridView g = grid(1, 3, 2, 4);
  EXPECT_EQ(g.key({-3, 1, 7}), g.key({5, 1, 7}));
  EXPECT_EQ(g.key({-3, 1, 7}), g.key({-3, -3, 7}));
  EXPECT_EQ(g.key({-3, 1, 7}), g.key({-3, 1, -9}));
}

// The particles that the runs around a cell hold, when each cell of the table holds `population(key)` of
// them.
template <class Population>
std::multiset<uint32_t> visited(GridView g, CellCoordinates around, const Population& population) {
  std::vector<uint32_t> start{0};
  for (uint32_t key = 0; key < g.cell_count(); ++key) start.push_back(start.back() + population(key));
  g.start = {start.data(), static_cast<uint32_t>(start.size())};
  std::multiset<uint32_t> seen;
  for_each_run(g, around, [&](uint32_t begin, uint32_t end) {
    for (uint32_t i = begin; i < end; ++i) seen.insert(i);
  });
  for (int n = 0; n < 27; ++n) {
    const uint32_t key = g.key({around.x + n % 3 - 1, around.y + n / 3 % 3 - 1, around.z + n / 9 - 1});
    for (uint32_t i = start[key]; i < start[key + 1]; ++i) EXPECT_EQ(seen.count(i), 1u) << "particle " << i;
  }
  return seen;
}

TEST(Grid, RunsHoldThe27CellsAndNothingElse) {
  const GridView g = grid(1, 2, 3, 2);
  for (int x = -5; x < 6; ++x) {
    const CellCoordinates around{x, 2 * x, 7 - x};
    EXPECT_EQ(visited(g, around, [](uint32_t) { return 2u; }).size(), 54u);
    visited(g, around, [](uint32_t key) { return key % 3 ? 0u : 4u; });
    visited(g, around, [](uint32_t key) { return key % 5 ? 3u : 0u; });
    EXPECT_TRUE(visited(g, around, [](uint32_t) { return 0u; }).empty());
  }
}

}  // namespace
}  // namespace meniscus::pbd
