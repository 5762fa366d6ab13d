// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Neighbour lists against all pairs.
#include <gtest/gtest.h>
#include <meniscus/error.h>

#include <algorithm>
#include <iterator>
#include <random>

#include "pbd/device/cpu/cpu_device.h"
#include "pbd/math/vec.h"
#include "pbd/neighbour_search.inl"
#include "tests/bench/harness/solver_bench.h"
#include "tests/devices.h"

namespace meniscus::tests {
namespace {

class NeighbourTest : public OnDevice {
 protected:
  std::unique_ptr<SolverBench> bench_ = make_solver_bench(GetParam());
  std::mt19937 random_{11};

  Vec3 in_box(Vec3 lower, Vec3 upper) {
    std::uniform_real_distribution<float> unit(0, 1);
    const float x = unit(random_), y = unit(random_), z = unit(random_);
    return lower + Vec3{x * (upper.x - lower.x), y * (upper.y - lower.y), z * (upper.z - lower.z)};
  }

  std::vector<Vec3> cloud(int count, Vec3 lower, Vec3 upper) {
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) points.push_back(in_box(lower, upper));
    return points;
  }

  /// Expects that each pair nearer than h is listed once on both sides; pairs within rounding of h may or may
  /// not be.
  void expect_all_pairs(const std::vector<Vec3>& points, float h) {
    const NeighbourLists lists = bench_->neighbours(points, h);
    ASSERT_EQ(lists.of.size(), points.size());
    for (uint32_t i = 0; i < points.size(); ++i) check_list(points, h, i, lists);
  }

  /// h / 2 apart at h = 0.1 m, and moved from there by up to a third of that.
  std::vector<Vec3> shaken_lattice(int along_x, int along_y, int along_z) {
    constexpr float spacing = 0.05f;
    std::vector<Vec3> points;
    for (int n = 0; n < along_x * along_y * along_z; ++n) {
      const Vec3 corner{float(n % along_x), float(n / along_x % along_y), float(n / along_x / along_y)};
      points.push_back(spacing * (corner + in_box({0, 0, 0}, {0.33f, 0.33f, 0.33f})));
    }
    return points;
  }

  /// Compares the lists of many particles at h = 0.1 m with those of a few at one end along x. Pairs within a
  /// few thousandths of h may or may not be listed, on both sides.
  void expect_those_of_a_slab(const std::vector<Vec3>& points) {
    const NeighbourLists all = bench_->neighbours(points, 0.1f);
    std::vector<Vec3> slab;
    std::vector<uint32_t> number;
    for (uint32_t i = 0; i < points.size(); ++i) {
      if (points[i].x > 0.3f) continue;
      slab.push_back(points[i]);
      number.push_back(i);
    }
    const NeighbourLists few = bench_->neighbours(slab, 0.1f);
    for (uint32_t n = 0; n < slab.size(); ++n) {
      if (slab[n].x > 0.2f) continue;  // what is beyond the slab is missing there
      std::vector<uint32_t> part;
      for (uint32_t j : few.of[n]) {
        if (j < slab.size()) part.push_back(number[j]);
      }
      std::sort(part.begin(), part.end());
      const uint32_t i = number[n];
      const std::vector<uint32_t> whole = listed(all, i);
      EXPECT_EQ(std::adjacent_find(whole.begin(), whole.end()), whole.end()) << "particle " << i;
      std::vector<uint32_t> different;
      std::set_symmetric_difference(whole.begin(), whole.end(), part.begin(), part.end(),
                                    std::back_inserter(different));
      for (uint32_t j : different) {
        ASSERT_NEAR(length(points[i] - points[j]), 0.1f, 0.0004f) << "particles " << i << " and " << j;
      }
      for (uint32_t j : whole) {
        const std::vector<uint32_t> its = listed(all, j);
        ASSERT_TRUE(std::binary_search(its.begin(), its.end(), i)) << j << " does not list " << i;
      }
    }
  }

 private:
  static std::vector<uint32_t> listed(const NeighbourLists& lists, uint32_t i) {
    std::vector<uint32_t> list = lists.of[i];
    std::erase(list, NeighbourLists::padding);
    std::sort(list.begin(), list.end());
    return list;
  }

  static void check_list(const std::vector<Vec3>& points, float h, uint32_t i, const NeighbourLists& lists) {
    std::vector<uint32_t> list = lists.of[i];
    EXPECT_EQ(list.size() % lists.group, 0u) << "particle " << i;
    const auto end = std::find(list.begin(), list.end(), NeighbourLists::padding);
    EXPECT_EQ(std::count(end, list.end(), NeighbourLists::padding), list.end() - end) << "particle " << i;
    EXPECT_LT(list.end() - end, static_cast<std::ptrdiff_t>(lists.group)) << "particle " << i;
    list.erase(end, list.end());
    std::sort(list.begin(), list.end());
    EXPECT_EQ(std::adjacent_find(list.begin(), list.end()), list.end()) << "particle " << i << " lists twice";
    for (uint32_t j = 0; j < points.size(); ++j) {
      const float d2 = dot(points[i] - points[j], points[i] - points[j]);
      const bool listed = std::binary_search(list.begin(), list.end(), j);
      if (std::fabs(d2 - h * h) <= 1e-6f * h * h) continue;
      ASSERT_EQ(listed, i != j && d2 < h * h) << i << " and " << j << " at " << std::sqrt(d2) / h << " h";
    }
    EXPECT_TRUE(list.empty() || list.back() < points.size()) << "particle " << i << " lists a stranger";
  }
};

TEST_P(NeighbourTest, OfNoParticleAndOfOne) {
  expect_all_pairs({}, 0.1f);
  expect_all_pairs({{3, -4, 5}}, 0.1f);
}

TEST_P(NeighbourTest, OfARandomCloud) {
  expect_all_pairs(cloud(2000, {-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f}), 0.1f);
}

TEST_P(NeighbourTest, OfALatticeWhosePairsLieOnTheEdgeOfReach) {
  std::vector<Vec3> points;
  for (int n = 0; n < 1000; ++n) {
    points.push_back(0.25f * Vec3{float(n % 10), float(n / 10 % 10), float(n / 100)});
  }
  expect_all_pairs(points, 0.5f);  // exact in floats: at distance h they do not count
  for (const auto& list : bench_->neighbours(points, 0.5f).of) {
    EXPECT_LE(std::count_if(list.begin(), list.end(), [](uint32_t j) { return j < 1000; }), 26);
  }
}

TEST_P(NeighbourTest, OfClustersInAWideSpace) {
  std::vector<Vec3> points;
  for (int n = 0; n < 12; ++n) {
    const Vec3 centre = in_box({-40, -40, -40}, {40, 40, 40});
    for (Vec3 p : cloud(60, {-0.15f, -0.15f, -0.15f}, {0.15f, 0.15f, 0.15f})) points.push_back(centre + p);
  }
  expect_all_pairs(points, 0.1f);
}

TEST_P(NeighbourTest, OfAThinSheetAndALongThread) {
  expect_all_pairs(cloud(1500, {-2, 0, -2}, {2, 0.01f, 2}), 0.1f);
  expect_all_pairs(cloud(1500, {-30, 0, 0}, {30, 0.02f, 0.02f}), 0.1f);
}

TEST_P(NeighbourTest, FarFromTheOrigin) {
  expect_all_pairs(cloud(800, {1e4f, -1e4f, 1e4f}, {1e4f + 0.5f, -1e4f + 0.5f, 1e4f + 0.5f}), 0.1f);
}

TEST_P(NeighbourTest, WithStraysAMillionMetresAway) {
  std::vector<Vec3> points = cloud(500, {0, 0, 0}, {0.4f, 0.4f, 0.4f});
  points.push_back({1e6f, 0.2f, 0.2f});
  points.push_back({-1e6f, -1e6f, 1e6f});
  points.push_back({-1e6f, -1e6f, 1e6f});
  points.push_back({0.2f, 1e12f, 0.2f});
  points.push_back({0.2f, 3e30f, 0.2f});
  expect_all_pairs(points, 0.1f);
}

TEST_P(NeighbourTest, OfPointsInOnePlace) {
  std::vector<Vec3> points(40, Vec3{0.3f, -0.2f, 0.1f});
  for (Vec3 p : cloud(100, {0.2f, -0.3f, 0}, {0.4f, -0.1f, 0.2f})) points.push_back(p);
  expect_all_pairs(points, 0.1f);
}

TEST_P(NeighbourTest, OfAClumpThatOverflowsTheLists) {
  std::vector<Vec3> points = cloud(300, {0, 0, 0}, {0.05f, 0.05f, 0.05f});
  for (Vec3 p : cloud(300, {1, 1, 1}, {1.5f, 1.5f, 1.5f})) points.push_back(p);
  expect_all_pairs(points, 0.1f);
  expect_all_pairs(std::vector<Vec3>(700, Vec3{-1, -1, -1}), 0.1f);
}

// More than teams of threads work on: the lists of each particle are then one thread's.
TEST_P(NeighbourTest, OfSeventyThousandParticlesAreThoseOfASlab) {
  expect_those_of_a_slab(cloud(70000, {0, 0, 0}, {6, 1.2f, 1.2f}));
}

TEST_P(NeighbourTest, WhoseIndicesAreCloseAreThoseOfASlab) {
  expect_those_of_a_slab(shaken_lattice(100, 40, 40));
}

TEST_P(NeighbourTest, WhoseIndicesAreFarApartInParticlesOfLargeLayersAreThoseOfASlab) {
  expect_those_of_a_slab(shaken_lattice(400, 100, 4));
}

TEST_P(NeighbourTest, OfManyParticlesFarFromTheOriginAreThoseOfASlab) {
  std::vector<Vec3> points = shaken_lattice(100, 40, 40);
  for (Vec3& p : points) p = p + Vec3{0, -300, 200};
  expect_those_of_a_slab(points);
  for (Vec3& p : points) p = p + Vec3{0, -3e4f, 2e4f};
  expect_those_of_a_slab(points);
}

// A table with a cell for each position would be too large for a wide world, so cells share entries.
TEST_P(NeighbourTest, OfManyParticlesInAWideSpaceAreThoseOfASlab) {
  std::vector<Vec3> points = shaken_lattice(20, 60, 60);
  for (int n = 0; n < 3000; ++n) points.push_back(in_box({1, 0, 0}, {100, 50, 50}));
  expect_those_of_a_slab(points);
}

TEST_P(NeighbourTest, ListsComeInTheSameOrderEachTime) {
  const std::vector<Vec3> points = cloud(2000, {-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f});
  EXPECT_EQ(bench_->neighbours(points, 0.1f).of, bench_->neighbours(points, 0.1f).of);
}

MENISCUS_ON_EACH_DEVICE(NeighbourTest);

// Rows that are full at h = 2 s have eight particles a reach.
TEST(NeighbourStrips, AreAsWideAsKeepsIndicesClose) {
  using pbd::neighbour_kernels::strip_bits_for;
  EXPECT_EQ(strip_bits_for({160, 45, 56}, 1'000'000), 31u);  // layers of 18,000: one strip
  for (float along_x : {50.0f, 260.0f, 410.0f, 1500.0f}) {
    const uint32_t rows = 1u << strip_bits_for({along_x, 1000, 10}, 100'000'000);
    EXPECT_LE(8 * along_x * float(rows + 1), float(pbd::NeighbourView::narrow_reach)) << along_x;
    EXPECT_GT(8 * along_x * float(2 * rows + 1), float(pbd::NeighbourView::narrow_reach)) << along_x;
  }
  EXPECT_EQ(strip_bits_for({5000, 1000, 10}, 100'000'000), 0u);  // a row is more than is close
}

// A million particles, one of them with five thousand neighbours, need more entries than 32 bits count: they
// are there, or it is said that they are not.
TEST(NeighbourCapacity, ListsBeyondThirtyTwoBitsAreThereOrRefused) {
  pbd::CpuDevice device;
  pbd::NeighbourSearch<pbd::CpuDevice> search(device, 0.1f);
  search.reserve(1 << 20);
  try {
    search.grow_rows(5000);
    EXPECT_GE(device.memory().bytes, (size_t{1} << 20) * 5000 * sizeof(uint32_t));
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::out_of_memory);
  }
}

}  // namespace
}  // namespace meniscus::tests
