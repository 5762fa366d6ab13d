// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The pipeline of phases: its order does not depend on that of the calls, and each phase has exactly one
// part.
#include "pbd/pipeline.h"

#include <gtest/gtest.h>

#include <vector>

namespace meniscus::pbd {
namespace {

enum class Meal { breakfast, lunch, dinner, count };

constexpr const char* phase_name(Meal meal) {
  constexpr std::array names{"breakfast", "lunch", "dinner"};
  return names[static_cast<std::size_t>(meal)];
}

std::string error_of(const auto& call) {
  try {
    call();
  } catch (const std::logic_error& error) {
    return error.what();
  }
  return "";
}

TEST(Pipeline, VisitsPartsInTheOrderOfThePhases) {
  int one = 1, two = 2, three = 3;
  Pipeline<Meal, int> pipeline;
  pipeline.place(Meal::dinner, three).place(Meal::breakfast, one).place(Meal::lunch, two);
  std::vector<int> visited;
  pipeline.for_each([&](int part) { visited.push_back(part); });
  EXPECT_EQ(visited, (std::vector{1, 2, 3}));
}

TEST(Pipeline, RefusesAPhaseWithoutAPart) {
  int part = 0, visits = 0;
  Pipeline<Meal, int> pipeline;
  pipeline.place(Meal::dinner, part).place(Meal::breakfast, part);
  EXPECT_EQ(error_of([&] { pipeline.for_each([&](int) { ++visits; }); }), "no part for the phase lunch");
  EXPECT_EQ(visits, 0);
}

TEST(Pipeline, RefusesASecondPartForAPhase) {
  int part = 0;
  Pipeline<Meal, int> pipeline;
  pipeline.place(Meal::dinner, part);
  EXPECT_EQ(error_of([&] { pipeline.place(Meal::dinner, part); }), "two parts for the phase dinner");
}

}  // namespace
}  // namespace meniscus::pbd
