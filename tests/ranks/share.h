// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Runs a shared world on ranks that are threads.
#pragma once

#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "sdk/world/shared/shared_world.h"
#include "tests/ranks/thread_ranks.h"

namespace meniscus::tests {

inline constexpr pbd::CutPolicy restless_cuts{.every = 1, .most_imbalance = 0, .shift = 2};

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

}  // namespace meniscus::tests
