// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The order of points by cell, and of particles that have contacts, does not depend on the order of arrival.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include "pbd/contacts.h"
#include "pbd/neighbour_search.h"

namespace meniscus::pbd {
namespace {

template <class T>
View<T> view(std::vector<T>& values) {
  return {values.data(), static_cast<uint32_t>(values.size())};
}

// Cells with so many points each, placed in a random order, have their points in the order of their
// numbers, which are random as well.
void expect_order(const std::vector<uint32_t>& sizes) {
  std::mt19937 random(7);
  std::vector<uint32_t> key, start{0};
  for (uint32_t cell = 0; cell < sizes.size(); ++cell) {
    key.insert(key.end(), sizes[cell], cell);
    start.push_back(start.back() + sizes[cell]);
  }
  std::shuffle(key.begin(), key.end(), random);
  std::vector<uint32_t> number(key.size()), expected(key.size()), order(key.size());
  std::iota(number.begin(), number.end(), 0u);
  std::shuffle(number.begin(), number.end(), random);
  std::iota(expected.begin(), expected.end(), 0u);
  std::sort(expected.begin(), expected.end(), [&](uint32_t a, uint32_t b) {
    return std::pair(key[a], number[a]) < std::pair(key[b], number[b]);
  });
  std::vector<uint32_t> placed = expected;
  for (uint32_t cell = 0; cell < sizes.size(); ++cell)
    std::shuffle(placed.begin() + start[cell], placed.begin() + start[cell + 1], random);

  std::vector<uint32_t> placed_number(placed.size());
  std::transform(placed.begin(), placed.end(), placed_number.begin(), [&](uint32_t i) { return number[i]; });
  const CellOrder cells{view(key), view(start), view(placed), view(placed_number), view(order)};
  for (uint32_t i = 0; i < key.size(); ++i) EXPECT_EQ(cells.find(i), expected[i]) << "place " << i;
  EXPECT_EQ(order, expected);
}

TEST(CellOrder, IsThatOfNumbers) {
  expect_order({1, 2, 0, 3, 16, 0, 5});
}

TEST(CellOrder, IsSoInCellsOfMany) {
  expect_order({17, 1, 300, 64});
}

class TouchingTest : public testing::Test {
 protected:
  // What is found by going through the list.
  std::vector<uint32_t> listed() {
    std::vector<uint32_t> found;
    for (uint32_t k = 0; k < list_.size(); ++k) {
      const uint32_t i = touching().at(k, view(start_));
      if (i != no_index) found.push_back(i);
    }
    std::sort(found.begin(), found.end());
    return found;
  }
  void count(std::vector<uint32_t> contacts) {
    std::vector<uint32_t> none(contacts.size(), 0);
    const ContactCounter counter{view(none), touching(), true};
    start_ = {0};
    for (uint32_t i = 0; i < contacts.size(); ++i) {
      counter.add(i, contacts[i]);
      start_.push_back(start_.back() + contacts[i]);
    }
    EXPECT_EQ(none, contacts);
  }
  TouchingView touching() { return {view(list_), view(counts_)}; }

  std::vector<uint32_t> list_ = std::vector<uint32_t>(6, 0), counts_{0, 0}, start_;
};

TEST_F(TouchingTest, ListsThoseThatHaveContactsOnce) {
  count({0, 1, 3, 0, 0, 1, 2});
  EXPECT_EQ(listed(), (std::vector<uint32_t>{1, 2, 5, 6}));
  EXPECT_EQ(counts_, (std::vector<uint32_t>{2, 2}));
}

TEST_F(TouchingTest, WithoutRoomWritesNothingElsewhere) {
  list_.resize(8, 77);
  list_.resize(6);  // what lies behind still belongs to the vector
  count({1, 2, 1, 2, 1, 2, 1, 2, 1, 1, 1, 1, 1, 1, 1, 1});
  EXPECT_GT(counts_[0], 6u);
  EXPECT_EQ(list_.data()[6], 77u);
  EXPECT_EQ(list_.data()[7], 77u);
  for (uint32_t i : listed()) EXPECT_LT(i, 16u);
}

}  // namespace
}  // namespace meniscus::pbd
