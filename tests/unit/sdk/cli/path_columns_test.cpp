// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the search for displacements that meet a box.
#include "sdk/cli/record/path_columns.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <set>

namespace meniscus::cli {
namespace {

class Random {
 public:
  Vec3 point(float size) { return {size * share_(engine_), size * share_(engine_), size * share_(engine_)}; }

 private:
  std::mt19937 engine_{3};
  std::uniform_real_distribution<float> share_{-1, 1};
};

// Numbers are by columns, so displacements are identified by where they begin.
TEST(PathColumns, FindAllPathsThatMeetABox) {
  Random random;
  std::vector<Path> paths;
  for (int k = 0; k < 2000; ++k) {
    const Vec3 from = random.point(2);
    paths.push_back({from, from + random.point(k % 50 ? 0.02f : 0.5f)});
  }
  const Aabb region{{-3, -3, -3}, {3, 3, 3}};
  const PathColumns columns(paths, region);
  ASSERT_EQ(columns.count(), paths.size());
  for (int k = 0; k < 200; ++k) {
    const Vec3 corner = random.point(2.5f);
    const Aabb box = around({corner, corner + random.point(0.3f)});
    std::multiset<float> expected, found;
    for (const Path& path : paths)
      if (pbd::overlap(around(path), box)) expected.insert(path.from.x);
    columns.for_each_near(box, [&](std::size_t n, const Path& path) {
      EXPECT_LT(n, paths.size());
      found.insert(path.from.x);
    });
    EXPECT_EQ(found, expected);
  }
}

TEST(PathColumns, KeepWhatMeetsTheirRegion) {
  const std::vector<Path> paths{
      {{0, 0, 0}, {0.1f, 0, 0}}, {{-2, 0, 0}, {2, 0, 0}}, {{0, -900, 0}, {0, -990, 0}}};
  EXPECT_EQ(PathColumns(paths, {{-1, -1, -1}, {1, 1, 1}}).count(), 2u);
  EXPECT_EQ(PathColumns({}, {{-1, -1, -1}, {1, 1, 1}}).count(), 0u);
}

TEST(PathColumns, WorkWithoutExtent) {
  int found = 0;
  const Aabb point{{0, 0, 0}, {0, 0, 0}};
  const PathColumns columns({{{0, 0, 0}, {0, 0, 0}}, {{0, 2, 0}, {0, 3, 0}}}, point);
  columns.for_each_near(point, [&](std::size_t, const Path&) { ++found; });
  EXPECT_EQ(found, 1);
}

// A run that has gone wrong is still counted to its end.
TEST(PathColumns, BearWhatIsNotFinite) {
  const float nan = std::numeric_limits<float>::quiet_NaN(),
              infinite = std::numeric_limits<float>::infinity();
  const std::vector<Path> paths{
      {{0, 0, 0}, {0, 0.1f, 0}}, {{nan, 0, 0}, {0, nan, nan}}, {{0, 0, 0}, {infinite, 0, 0}}};
  const Aabb regions[] = {{{-1, -1, -1}, {1, 1, 1}}, {{nan, 0, 0}, {infinite, 1, 1}}};
  for (const Aabb& region : regions) {
    PathColumns(paths, region).for_each_near({{-1, -1, -1}, {1, 1, 1}}, [&](std::size_t n, const Path&) {
      EXPECT_LT(n, paths.size());
    });
  }
}

}  // namespace
}  // namespace meniscus::cli
