// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Sums over a body's contacts in integers.
#include "collision/body/fixed_sums.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

namespace meniscus::collision::body_kernels {
namespace {

constexpr float reach = 0.5f;  // m
constexpr int64_t largest = std::numeric_limits<int64_t>::max();

BodyProxy body_of(uint32_t contacts) {
  BodyProxy body{};
  body.inverse_mass = 0.25f;
  body.end = contacts;
  return body;
}

/// The sum of contacts that push along x, kg·m, in this many lanes.
IntegerSum sum_of(const std::vector<float>& pushes, uint32_t lanes) {
  BodyProxy body = body_of(static_cast<uint32_t>(pushes.size()));
  std::vector<pbd::Contact> contacts(pushes.size());
  std::vector<uint32_t> grouped(pushes.size());
  std::iota(grouped.begin(), grouped.end(), 0u);
  for (size_t k = 0; k < pushes.size(); ++k) {
    contacts[k].normal = {1, 0, 0};
    contacts[k].normal_multiplier = pushes[k];
    contacts[k].arm = {0, 0.25f, 0};
  }
  float reaches[] = {reach};
  std::vector<IntegerSum> partial(lanes);
  for (uint32_t n = 0; n < lanes; ++n)
    SumLanesInIntegers{{grouped.data(), static_cast<uint32_t>(grouped.size())},
                       {&body, 1},
                       {reaches, 1},
                       {contacts.data(), static_cast<uint32_t>(contacts.size())},
                       {partial.data(), lanes},
                       lanes}(n);
  return total_of({partial.data(), lanes}, 0, lanes);
}

TEST(FixedSums, AreTheSameInAnyOrderAndAnyLanes) {
  std::vector<float> pushes;
  for (int k = 0; k < 100; ++k) pushes.push_back(0.001f * static_cast<float>(k % 17 - 5));
  const IntegerSum expected = sum_of(pushes, 1);
  std::swap(pushes.front(), pushes.back());
  std::reverse(pushes.begin() + 3, pushes.end() - 20);
  const IntegerSum found = sum_of(pushes, 8);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(found.push[k], expected.push[k]);
    EXPECT_EQ(found.twist[k], expected.twist[k]);
  }
  EXPECT_NE(expected.push[0], 0);
  EXPECT_NE(expected.twist[2], 0);
  EXPECT_EQ(expected.overflows + found.overflows, 0u);
}

TEST(FixedSums, AContactThatMovesTheBodyTooFarIsCounted) {
  const float mass = 4;
  EXPECT_EQ(sum_of({100 * mass}, 1).overflows, 0u);
  EXPECT_EQ(sum_of({300 * mass}, 1).overflows, 1u);
  EXPECT_EQ(sum_of({-300 * mass, 1}, 8).overflows, 1u);
}

TEST(FixedSums, ASumThatWrapsAroundIsCounted) {
  IntegerSum sum{};
  sum.push[1] = largest - 1;
  IntegerSum one{};
  one.push[1] = 1;
  sum.add(one);
  EXPECT_EQ(sum.overflows, 0u);
  sum.add(one);
  EXPECT_EQ(sum.overflows, 1u);
  sum = {};
  one.twist[2] = -largest;
  sum.add(one);
  sum.add(one);
  EXPECT_EQ(sum.overflows, 1u);
}

}  // namespace
}  // namespace meniscus::collision::body_kernels
