// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Runs a shared world on ranks that are threads.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "sdk/world/shared/shared_world.h"
#include "tests/ranks/failing_ranks.h"
#include "tests/ranks/thread_ranks.h"
#include "tests/worlds.h"

namespace meniscus::tests {

using pbd::CutKind;

inline constexpr pbd::CutPolicy slabs{.kind = CutKind::slabs}, pencils{.kind = CutKind::pencils};
inline constexpr pbd::CutPolicy restless_slabs{
    .kind = CutKind::slabs, .every = 1, .most_imbalance = 0, .shift = 2};
inline constexpr pbd::CutPolicy restless_pencils{
    .kind = CutKind::pencils, .every = 1, .most_imbalance = 0, .shift = 2};

/// So many ranks, and how they cut the world.
using Sharing = std::vector<std::pair<int, pbd::CutPolicy>>;

/// Makes the same world on each rank. Calls lead(world) on rank 0, and returns the errors of the ranks.
inline std::vector<std::string> share(int count, const pbd::CutPolicy& policy,
                                      const std::function<World()>& make,
                                      const std::function<void(World&)>& lead) {
  const auto ranks = make_thread_ranks(count);
  std::vector<std::string> errors(static_cast<size_t>(count));
  const auto run = [&](int r) {
    try {
      World world = make();
      SharedWorld shared(world, *ranks[static_cast<size_t>(r)], policy);
      shared.leads() ? lead(world) : static_cast<void>(shared.follow());
    } catch (const std::exception& error) {
      errors[static_cast<size_t>(r)] = error.what();
    }
  };
  std::vector<std::jthread> others;
  for (int r = 1; r < count; ++r) others.emplace_back(run, r);
  run(0);
  others.clear();
  return errors;
}

/// What a world tells is the same alone and shared: by default on 1 and 2 ranks, and on 3 whose cuts move
/// with every step.
inline void expect_the_same(const std::function<World()>& make,
                            const std::function<std::vector<std::string>(World&)>& told,
                            const Sharing& sharing = {{1, slabs}, {2, slabs}, {3, restless_slabs}}) {
  World alone = make();
  const std::vector<std::string> expected = told(alone);
  for (const auto& [ranks, policy] : sharing) {
    SCOPED_TRACE(ranks);
    std::vector<std::string> found;
    const auto errors = share(ranks, policy, make, [&](World& world) { found = told(world); });
    for (const std::string& error : errors) EXPECT_EQ(error, "");
    EXPECT_EQ(found, expected);
  }
}

/// Rank 1 of 3 fails at that call of its transport, within so many steps. All ranks end, and all errors name
/// it or are its own.
inline void expect_failure_to_end_all(const std::function<World()>& make, int call, int steps) {
  SCOPED_TRACE(call);
  const auto ranks = make_thread_ranks(3);
  std::vector<std::string> errors(3);
  const auto run_rank = [&](int r) {
    FailingRanks failing(*ranks[static_cast<size_t>(r)], r == 1 ? call : 0,
                         [] { throw Error(ErrorCode::device, "the test has cut the line"); });
    try {
      World world = make();
      SharedWorld shared(world, failing);
      shared.leads() ? run(world, steps, 0.008f) : static_cast<void>(shared.follow());
    } catch (const std::exception& error) {
      errors[static_cast<size_t>(r)] = error.what();
    }
  };
  {
    std::jthread first(run_rank, 1), second(run_rank, 2);
    run_rank(0);
  }
  EXPECT_NE(errors[0].find("rank 1 failed: the test has cut the line"), std::string::npos) << errors[0];
  EXPECT_NE(errors[1].find("the test has cut the line"), std::string::npos) << errors[1];
  EXPECT_NE(errors[2].find("rank 1 failed: the test has cut the line"), std::string::npos) << errors[2];
}

}  // namespace meniscus::tests
