// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The table of the pressure grid's nodes has the order of the cells that particles are sorted by.
#include "fluid/pressure_grid/node_table.h"

#include <gtest/gtest.h>

#include <random>

#include "pbd/grid.h"

namespace meniscus::fluid {
namespace {

TEST(NodeTable, HasTheOrderOfTheCellsWithStripsOfAnyHeight) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int32_t> anywhere(-1000, 1000);
  for (uint32_t strip_bits = 0; strip_bits <= 5; ++strip_bits) {
    pbd::GridView cells;
    cells.bits_x = 6;
    cells.bits_y = 5;
    cells.bits_z = 3;
    cells.strip_bits = strip_bits;
    const NodeTable nodes{{4, 5, 3}, strip_bits};
    for (int k = 0; k < 500; ++k) {
      const int32_t x = anywhere(random), y = anywhere(random), z = anywhere(random);
      const uint32_t node = nodes.index(x, y, z);
      for (int32_t slice = 0; slice < 4; ++slice)
        EXPECT_EQ(cells.key({4 * x + slice, y, z}), 4 * node + static_cast<uint32_t>(slice));
      const NodeCoordinates c = nodes.coordinates(node);
      EXPECT_EQ(c.at[0], x & 15);
      EXPECT_EQ(c.at[1], y & 31);
      EXPECT_EQ(c.at[2], z & 7);
    }
  }
}

}  // namespace
}  // namespace meniscus::fluid
