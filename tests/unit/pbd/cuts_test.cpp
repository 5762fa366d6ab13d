// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// How the columns of a shared world are divided among ranks.
#include <gtest/gtest.h>
#include <meniscus/error.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include "pbd/ranks/cuts.h"
#include "tests/expect_error.h"

namespace meniscus::pbd {
namespace {

ColumnCounts columns_of(int32_t layers_y, int32_t layers_z, uint64_t each = 1) {
  ColumnCounts columns{-7, 5, layers_y, layers_z, {}};
  columns.counts.assign(static_cast<size_t>(layers_y) * static_cast<size_t>(layers_z), each);
  return columns;
}

/// Uneven counts, half of the columns without any.
ColumnCounts scattered(int32_t layers_y, int32_t layers_z, uint32_t seed) {
  ColumnCounts columns = columns_of(layers_y, layers_z);
  std::mt19937 random(seed);
  for (uint64_t& count : columns.counts) count = random() % 2 ? random() % 100 : 0;
  return columns;
}

ColumnCounts layers(const std::vector<uint64_t>& along_z) {
  return {0, -7, 1, static_cast<int32_t>(along_z.size()), along_z};
}

/// Calls visit(y, z, count) for the columns, and some outside with no particles.
template <class Visit>
void for_each_column(const ColumnCounts& columns, const Visit& visit) {
  const Region box = columns.columns(), all = box.grown(5);
  for (int32_t z = all.first_z; z < all.end_z; ++z) {
    for (int32_t y = all.first_y; y < all.end_y; ++y) {
      const auto k = static_cast<size_t>((z - box.first_z) * columns.layers_y + y - box.first_y);
      visit(y, z, box.contains(y, z) ? columns.counts[k] : 0);
    }
  }
}

std::vector<uint64_t> by_rank(const Cuts& cuts, const ColumnCounts& columns) {
  std::vector<uint64_t> sums(static_cast<size_t>(cuts.ranks()));
  for_each_column(columns,
                  [&](int32_t y, int32_t z, uint64_t count) { sums[cuts.view().owner(y, z)] += count; });
  return sums;
}

TEST(Cuts, EvenLayersGiveEvenSlabs) {
  const ColumnCounts columns = layers(std::vector<uint64_t>(40, 100));
  const Cuts cuts(columns, 4, CutAxes::z);
  EXPECT_EQ(by_rank(cuts, columns), std::vector<uint64_t>(4, 1000));
  EXPECT_DOUBLE_EQ(cuts.imbalance(columns), 1);
  EXPECT_TRUE(cuts.are_slabs());
}

TEST(Cuts, EvenColumnsGiveFourEvenPencils) {
  const ColumnCounts columns = columns_of(20, 20);
  const Cuts cuts(columns, 4, CutAxes::both);
  EXPECT_EQ(by_rank(cuts, columns), std::vector<uint64_t>(4, 100));
  EXPECT_FALSE(cuts.are_slabs());
  for (int r = 0; r < 4; ++r) EXPECT_EQ(cuts.neighbours(r).size(), 3u);
}

TEST(Cuts, ThreeRanksMeetInATee) {
  const Cuts cuts(columns_of(20, 27), 3, CutAxes::both);
  EXPECT_FALSE(cuts.are_slabs());
  for (int r = 0; r < 3; ++r) EXPECT_EQ(cuts.neighbours(r).size(), 2u);
}

TEST(Cuts, AChannelIsCutAcrossAlone) {
  EXPECT_TRUE(Cuts(columns_of(8, 400), 8, CutAxes::both).are_slabs());
}

TEST(Cuts, EachColumnHasOneOwnerWhoseRegionContainsIt) {
  for (const int ranks : {1, 2, 3, 5, 8, 13}) {
    const ColumnCounts columns = scattered(30, 40, static_cast<uint32_t>(ranks));
    for (const Cuts& cuts :
         {Cuts(columns, ranks, CutAxes::both), Cuts(columns, ranks, CutAxes::both).moved(2),
          Cuts(columns, std::min(ranks, 10), CutAxes::y)}) {
      const auto expect_one = [&](int32_t y, int32_t z) {
        int owners = 0;
        for (int r = 0; r < cuts.ranks(); ++r) {
          const bool contains = cuts.region(r).contains(y, z);
          owners += contains;
          EXPECT_EQ(contains, cuts.view().owner(y, z) == static_cast<uint32_t>(r));
        }
        EXPECT_EQ(owners, 1);
      };
      for_each_column(columns, [&](int32_t y, int32_t z, uint64_t) { expect_one(y, z); });
      for (const int32_t far : {-1'000'000'000, 1'000'000'000}) {
        expect_one(far, 20);
        expect_one(10, far);
        expect_one(far, -far);
      }
    }
  }
}

/// Columns beside each other, of two ranks.
TEST(Cuts, NeighboursHaveColumnsBesideEachOther) {
  for (const int ranks : {2, 3, 7, 12}) {
    const ColumnCounts columns = scattered(40, 40, static_cast<uint32_t>(ranks));
    const Cuts cuts(columns, ranks, CutAxes::both);
    std::vector<std::set<int>> beside(static_cast<size_t>(ranks));
    for_each_column(columns, [&](int32_t y, int32_t z, uint64_t) {
      const auto owner = cuts.view().owner(y, z);
      for (int k = 0; k < 9; ++k) {
        const auto other = cuts.view().owner(y + k % 3 - 1, z + k / 3 - 1);
        if (other != owner) beside[owner].insert(static_cast<int>(other));
      }
    });
    for (int r = 0; r < ranks; ++r) {
      const std::vector<int> found = cuts.neighbours(r);
      EXPECT_EQ(std::set<int>(found.begin(), found.end()), beside[static_cast<size_t>(r)]);
    }
  }
}

TEST(Cuts, LoadCountsOwnParticlesAndGhosts) {
  for (const int ranks : {1, 4, 7}) {
    const ColumnCounts columns = scattered(30, 30, static_cast<uint32_t>(ranks));
    const Cuts cuts(columns, ranks, CutAxes::both);
    std::vector<uint64_t> loads(static_cast<size_t>(ranks));
    for_each_column(columns, [&](int32_t y, int32_t z, uint64_t count) {
      std::set<uint32_t> needing;
      for (int k = 0; k < 9; ++k) needing.insert(cuts.view().owner(y + k % 3 - 1, z + k / 3 - 1));
      for (const uint32_t r : needing) loads[r] += (r == cuts.view().owner(y, z) ? 4 : 5) * count;
    });
    EXPECT_EQ(cuts.load(columns), *std::max_element(loads.begin(), loads.end()));
  }
}

/// Of all places for the first cut, none is nearer to its share along the same axis, and the axis is the one
/// with fewer particles on the wrong side and beside it.
TEST(Cuts, TheFirstCutIsTheBestOfAll) {
  for (uint32_t seed = 0; seed < 50; ++seed) {
    const ColumnCounts columns = scattered(25, 30, seed);
    const Region all = columns.columns();
    const uint64_t total = columns.sum(all);
    struct Best {
      uint64_t wrong = ~uint64_t{0}, cost = 0;
    } best[2];
    const auto side = [&](int32_t from, int32_t to, bool along_y) {
      uint64_t sum = 0;
      for_each_column(columns, [&](int32_t y, int32_t z, uint64_t count) {
        const int32_t layer = along_y ? y : z;
        if (layer >= from && layer < to) sum += count;
      });
      return sum;
    };
    const auto cost_at = [&](int32_t at, bool along_y) {
      const uint64_t below = side(-100, at, along_y), wanted = total / 2;
      const uint64_t wrong = below > wanted ? below - wanted : wanted - below;
      return Best{wrong, wrong + side(at - 1, at + 1, along_y)};
    };
    for (const bool along_y : {false, true}) {
      for (int32_t at = (along_y ? all.first_y : all.first_z) + 3;
           at <= (along_y ? all.end_y : all.end_z) - 3; ++at) {
        const Best found = cost_at(at, along_y);
        if (found.wrong < best[along_y].wrong) best[along_y] = found;
      }
    }
    const Cut cut = Cuts(columns, 2, CutAxes::both).tree()[0];
    const Best chosen = cost_at(cut.at, cut.along_y);
    EXPECT_LE(chosen.wrong, best[cut.along_y].wrong + 1);  // halves are rounded
    EXPECT_LE(chosen.cost, std::min(best[0].cost, best[1].cost) + 1);
  }
}

TEST(Cuts, CrowdedEndsStillLeaveEachRankThreeLayers) {
  for (const auto& [y, z] :
       {std::pair{0, 0}, std::pair{0, 12}, std::pair{9, 0}, std::pair{9, 12}, std::pair{5, 6}}) {
    for (const CutAxes axes : {CutAxes::z, CutAxes::both}) {
      ColumnCounts columns = columns_of(10, 13);
      columns.counts[static_cast<size_t>(z * 10 + y)] = 100'000;
      const Cuts cuts(columns, 4, axes);
      for (int r = 0; r < 4; ++r) {
        const Region box = columns.columns(), own = cuts.region(r);
        EXPECT_GE(std::min(own.end_y, box.end_y) - std::max(own.first_y, box.first_y), Cuts::least_layers);
        EXPECT_GE(std::min(own.end_z, box.end_z) - std::max(own.first_z, box.first_z), Cuts::least_layers);
      }
    }
  }
}

/// Whatever fits can be cut, although each bisection looks at its own cut alone.
TEST(Cuts, WhereThereAreEnoughLayersTheyAreCut) {
  for (int32_t y = 1; y < 20; ++y) {
    for (int32_t z = 1; z < 20; ++z) {
      const ColumnCounts columns = scattered(y, z, static_cast<uint32_t>(20 * y + z));
      for (int ranks = 1; ranks <= 36; ++ranks) {
        for (const CutAxes axes : {CutAxes::y, CutAxes::z, CutAxes::both}) {
          if (!Cuts::fit(columns, ranks, axes)) continue;
          const Cuts cuts(columns, ranks, axes);
          ASSERT_EQ(cuts.ranks(), ranks);
          EXPECT_TRUE(axes == CutAxes::both || cuts.are_slabs());
        }
      }
    }
  }
  EXPECT_TRUE(Cuts::fit(columns_of(1, 9), 3, CutAxes::both));
  EXPECT_FALSE(Cuts::fit(columns_of(5, 8), 3, CutAxes::both));
  EXPECT_TRUE(Cuts::fit(columns_of(6, 6), 4, CutAxes::both));
  EXPECT_TRUE(Cuts::fit(columns_of(24, 24), 64, CutAxes::both));
}

TEST(Cuts, TooFewLayersAreRefused) {
  tests::expect_error(ErrorCode::capacity,
                      "8 layers of cells along the axis of its slabs; 3 ranks need 3 each",
                      [] { Cuts(columns_of(20, 8), 3, CutAxes::z); });
  tests::expect_error(ErrorCode::capacity,
                      "5 by 8 layers of cells along the axes of its pencils; 3 ranks need 3 each",
                      [] { Cuts(columns_of(5, 8), 3, CutAxes::both); });
}

TEST(Cuts, EmptyLayersAreAddedBehindTheOthers) {
  for (const bool along_y : {false, true}) {
    const ColumnCounts columns = scattered(4, 5, 1);
    ColumnCounts longer = columns;
    longer.extend(along_y, 9);
    EXPECT_EQ(along_y ? longer.layers_y : longer.layers_z, 9);
    for (int32_t y = 0; y < 4; ++y) {
      for (int32_t z = 0; z < 5; ++z) {
        const Region column{y - 7, y - 6, z + 5, z + 6};
        EXPECT_EQ(longer.sum(column), columns.sum(column));
      }
    }
    EXPECT_EQ(longer.sum(longer.columns()), columns.sum(columns.columns()));
  }
}

}  // namespace
}  // namespace meniscus::pbd
