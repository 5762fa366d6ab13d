// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Sort, scan, reduce and parallel_for against the standard library.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <random>

#include "tests/bench/harness/device_bench.h"
#include "tests/devices.h"
#include "tests/many_threads.h"

namespace meniscus::tests {
namespace {

class DeviceTest : public OnDevice {
 protected:
  std::unique_ptr<DeviceBench> bench_ = make_device_bench(GetParam());
  std::mt19937 random_{7};

  std::vector<uint32_t> numbers(uint32_t count) {
    std::vector<uint32_t> values(count);
    for (uint32_t& v : values) v = static_cast<uint32_t>(random_());
    return values;
  }
};

// Around the block sizes of either device, and well beyond them.
constexpr uint32_t sizes[] = {0, 1, 2, 127, 128, 129, 1000, 8191, 8192, 8193, 100000};

SortedPairs stable_sorted(const std::vector<uint32_t>& keys, uint32_t bits) {
  const uint32_t mask = (1u << bits) - 1;
  SortedPairs expected{{}, std::vector<uint32_t>(keys.size())};
  std::iota(expected.places.begin(), expected.places.end(), 0u);
  std::stable_sort(expected.places.begin(), expected.places.end(),
                   [&](uint32_t a, uint32_t b) { return (keys[a] & mask) < (keys[b] & mask); });
  for (uint32_t place : expected.places) expected.keys.push_back(keys[place]);
  return expected;
}

TEST_P(DeviceTest, SortIsTheStableOneForEverySize) {
  for (uint32_t size : sizes) {
    std::vector<uint32_t> keys = numbers(size);
    for (uint32_t& key : keys) key %= 1u << 17;
    const SortedPairs expected = stable_sorted(keys, 17), found = bench_->sort(keys, 17);
    EXPECT_EQ(found.keys, expected.keys) << size << " keys";
    EXPECT_EQ(found.places, expected.places) << size << " keys";
  }
}

TEST_P(DeviceTest, SortIsTheStableOneForEveryNumberOfBits) {
  for (uint32_t bits = 1; bits <= 30; ++bits) {
    std::vector<uint32_t> keys = numbers(20000);
    for (uint32_t& key : keys) key &= (1u << bits) - 1;
    EXPECT_EQ(bench_->sort(keys, bits).places, stable_sorted(keys, bits).places) << bits << " bits";
  }
}

TEST_P(DeviceTest, SortLooksAtTheLowBitsAlone) {
  const std::vector<uint32_t> keys = numbers(20000);
  for (uint32_t bits = 1; bits <= 30; ++bits) {
    EXPECT_EQ(bench_->sort(keys, bits).places, stable_sorted(keys, bits).places) << bits << " bits";
  }
}

TEST_P(DeviceTest, SortKeepsTheOrderOfEqualKeys) {
  const SortedPairs found = bench_->sort(std::vector<uint32_t>(50000, 5), 12);
  EXPECT_TRUE(std::is_sorted(found.places.begin(), found.places.end()));
}

TEST_P(DeviceTest, ScanAddsUpWhatComesBefore) {
  for (uint32_t size : sizes) {
    std::vector<uint32_t> values = numbers(size), expected(size + 1, 0);
    for (uint32_t& v : values) v %= 1000;
    std::partial_sum(values.begin(), values.end(), expected.begin() + 1);
    EXPECT_EQ(bench_->scan(values), expected) << size << " values";
  }
}

TEST_P(DeviceTest, ScanOfManyAndOfFewByTurns) {
  for (uint32_t size : {2000000u, 4097u, 1200001u, 4096u, 300000u}) {
    const std::vector<uint32_t> ones(size, 1);
    std::vector<uint32_t> expected(size + 1);
    std::iota(expected.begin(), expected.end(), 0u);
    EXPECT_EQ(bench_->scan(ones), expected) << size << " values";
  }
}

TEST_P(DeviceTest, ScanStaysAtItsLimit) {
  constexpr uint32_t size = 300000, limit = 1000000;
  std::vector<uint32_t> values = numbers(size), expected{0};
  for (uint32_t& v : values) {
    v %= 10;
    expected.push_back(std::min(limit, expected.back() + v));
  }
  EXPECT_EQ(expected.back(), limit);
  EXPECT_EQ(bench_->scan(values, limit), expected);
}

TEST_P(DeviceTest, ScanNotesTheLastSumAndTheMost) {
  pbd::SumNote note{0, 0};
  for (uint32_t size : {5000u, 70000u, 0u, 3u}) bench_->scan(std::vector<uint32_t>(size, 2), 100000, &note);
  EXPECT_EQ(note.last, 6u);
  EXPECT_EQ(note.most, 100000u);
}

TEST_P(DeviceTest, SmallAndLargeReadsGiveWhatWasWritten) {
  for (uint32_t size : {1u, 3u, 1023u, 1024u, 1025u, 50000u}) {
    std::vector<uint32_t> expected(size);
    std::iota(expected.begin(), expected.end(), 0u);
    EXPECT_EQ(bench_->resized(size, size, size), expected) << size << " values";
  }
}

TEST_P(DeviceTest, ReduceAddsUpEverything) {
  for (uint32_t size : sizes) {
    std::vector<float> values(size);
    double expected = 0, magnitude = 0;
    for (float& v : values) {
      v = std::uniform_real_distribution<float>(-1, 1)(random_);
      expected += v;
      magnitude += std::fabs(v);
    }
    EXPECT_NEAR(bench_->sum(values), expected, 1e-6 * magnitude) << size << " values";
  }
}

TEST_P(DeviceTest, ReduceGivesTheSameBitsEachTime) {
  std::vector<float> values(100000);
  for (float& v : values) v = std::uniform_real_distribution<float>(-1, 1)(random_);
  const float first = bench_->sum(values);
  for (int run = 0; run < 5; ++run) EXPECT_EQ(bench_->sum(values), first);
}

/// Few launches, which a GPU may be sent as a graph, and many; each count is seen once, and then again.
TEST_P(DeviceTest, WorkThatRepeatsIsTheSameEachTime) {
  for (uint32_t launches : {3u, 100u}) {
    for (uint32_t repeats : {1u, 4u}) {
      for (uint32_t count = 5000; count < 5060; ++count) {
        const uint32_t expected = (launches + 1) * count + launches;
        EXPECT_EQ(bench_->rounds(count, launches, repeats), std::vector<uint32_t>(repeats, expected))
            << count;
      }
    }
  }
}

/// From the second time on, unless too much else was new before.
TEST_P(DeviceTest, WorkThatRepeatsIsAGraphOnAGpu) {
  if (GetParam() == pbd::DeviceKind::cpu) GTEST_SKIP() << "has no graphs";
  bench_->rounds(1000, 3, 1);
  EXPECT_EQ(bench_->graphs_sent(), 0u);
  bench_->rounds(1000, 3, 10);
  EXPECT_GE(bench_->graphs_sent(), 9u);
  const uint64_t before = bench_->graphs_sent();
  for (uint32_t count = 100; count < 200; ++count) bench_->rounds(count, 3, 1);
  EXPECT_EQ(bench_->graphs_sent(), before);
  bench_->rounds(1000, 3, 10);
  EXPECT_EQ(bench_->graphs_sent(), before);  // nothing is put together for a while
  bench_->rounds(1000, 3, 1000);
  EXPECT_GT(bench_->graphs_sent(), before + 300);
}

/// Bytes between members are cleared, so that lists of launches can be compared, and nothing else is: GCC 12
/// looks in the wrong place behind an array of structs of more than 64 bytes.
TEST_P(DeviceTest, KernelsGetWhatTheyAreGiven) {
  std::array<float, 32> pairs;
  for (size_t k = 0; k < pairs.size(); ++k) pairs[k] = 1.7f + 2.3f * static_cast<float>(k);
  const std::vector<float> found = bench_->doubled(pairs, 11.3f);
  for (size_t k = 0; k < 16; ++k) EXPECT_EQ(found[k], 2 * (pairs[2 * k] + pairs[2 * k + 1])) << k;
  EXPECT_EQ(found[16], 11.3f);
}

/// What differs by a launch is changed in the graph that there is: none of these rounds is like another.
TEST_P(DeviceTest, WorkThatNearlyRepeatsIsRight) {
  constexpr uint32_t count = 1000, launches = 3, rounds = 40;
  std::vector<uint32_t> expected;
  for (uint32_t k = 0; k < rounds; ++k) expected.push_back((launches + 1) * count - k + launches);
  bench_->rounds(count, launches, 4);
  const uint64_t before = bench_->graphs_sent();
  EXPECT_EQ(bench_->rounds(count, launches, rounds, rounds), expected);
  if (GetParam() == pbd::DeviceKind::cuda) {
    EXPECT_EQ(bench_->graphs_sent(), before + rounds);
  }
}

TEST_P(DeviceTest, ParallelForVisitsEachIndexOnce) {
  for (uint32_t size : sizes) {
    std::vector<uint32_t> expected(size + 1, 1);
    expected.back() = 0;
    EXPECT_EQ(bench_->visits(size), expected) << size << " indices";
  }
}

MENISCUS_ON_EACH_DEVICE(DeviceTest);

TEST(CpuDevice, TheNumberOfThreadsLeavesNoTrace) {
  const ManyThreads allowed;
  std::mt19937 random(3);
  std::vector<float> values(123456);
  for (float& v : values) v = std::uniform_real_distribution<float>(-1, 1)(random);
  std::vector<uint32_t> keys(123456);
  for (uint32_t& key : keys) key = static_cast<uint32_t>(random()) & 0xfff;
  const std::unique_ptr<DeviceBench> one = make_cpu_bench(1);
  for (int threads : {2, 3, 8}) {
    const std::unique_ptr<DeviceBench> many = make_cpu_bench(threads);
    EXPECT_EQ(std::bit_cast<uint32_t>(many->sum(values)), std::bit_cast<uint32_t>(one->sum(values)));
    EXPECT_EQ(many->sort(keys, 12).places, one->sort(keys, 12).places);
    EXPECT_EQ(many->scan(keys), one->scan(keys));
  }
}

}  // namespace
}  // namespace meniscus::tests
