// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "pbd/math/exact_sum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

namespace meniscus::pbd {
namespace {

ExactSum sum_of(const std::vector<double>& values) {
  ExactSum sum;
  for (const double v : values) sum = sum + ExactSum::of(v);
  return sum;
}

TEST(ExactSum, KeepsSingleNumbers) {
  for (const double x : {0.0, 1.0, -1.0, 0.1, -0.1, 1e-12, -3.75e17, 0x1p-48, -0x1p-96, 0x1.fffffffffffffp59})
    EXPECT_EQ(ExactSum::of(x).value(), x) << x;
}

TEST(ExactSum, LosesNothingWhereAFloatingPointSumDoes) {
  EXPECT_EQ(sum_of({1e17, 1, -1e17}).value(), 1);
  EXPECT_EQ(sum_of({-1e17, 0x1p-40, 1e17}).value(), 0x1p-40);
  EXPECT_DOUBLE_EQ(sum_of(std::vector<double>(1000, -0.001)).value(), -1000 * 0.001);
}

TEST(ExactSum, IsTheSameInAnyOrderAndOverAnyParts) {
  std::mt19937 random(7);
  std::vector<double> values(1000);
  for (double& v : values)
    v = std::ldexp(std::uniform_real_distribution<double>(-1, 1)(random),
                   std::uniform_int_distribution<int>(-50, 50)(random));
  const auto expected = sum_of(values).split();
  std::shuffle(values.begin(), values.end(), random);
  EXPECT_EQ(sum_of(values).split(), expected);
  // What ranks do: each sums a part, and the parts of the sums are added up one by one.
  std::array<uint64_t, ExactSum::parts> all{};
  for (const size_t first : {0u, 100u, 350u, 800u}) {
    const size_t end = first == 0 ? 100 : first == 100 ? 350 : first == 350 ? 800 : 1000;
    const auto own = sum_of({values.begin() + static_cast<std::ptrdiff_t>(first),
                             values.begin() + static_cast<std::ptrdiff_t>(end)})
                         .split();
    for (size_t k = 0; k < all.size(); ++k) all[k] += own[k];
  }
  EXPECT_EQ(ExactSum::joined(all.data()).split(), expected);
}

TEST(ExactSum, WhatHasNoRoomMakesItNan) {
  for (const double x :
       {0x1p60, -0x1p60, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    EXPECT_TRUE(std::isnan(sum_of({1, x, 1}).value())) << x;
}

}  // namespace
}  // namespace meniscus::pbd
