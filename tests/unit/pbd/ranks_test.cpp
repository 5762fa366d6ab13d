// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Ranks that are threads: messages and failures.
#include <gtest/gtest.h>
#include <meniscus/error.h>

#include <functional>
#include <thread>

#include "pbd/ranks/ranks.h"
#include "tests/ranks/thread_ranks.h"

namespace meniscus::pbd {
namespace {

void on_ranks(int count, const std::function<void(Ranks&)>& run) {
  const auto ranks = tests::make_thread_ranks(count);
  std::vector<std::jthread> threads;
  for (const auto& rank : ranks) threads.emplace_back([&run, &rank] { run(*rank); });
}

TEST(Ranks, ExchangeKeepsTheOrderOfMessagesAndSkipsEmptyOnes) {
  on_ranks(2, [](Ranks& ranks) {
    const int other = 1 - ranks.rank();
    const int32_t first = 10 + ranks.rank(), second = 20 + ranks.rank();
    int32_t got[2] = {};
    const Sent sent[] = {{other, &first, 4}, {other, nullptr, 0}, {other, &second, 4}};
    const Received received[] = {{other, nullptr, 0}, {other, &got[0], 4}, {other, &got[1], 4}};
    ranks.exchange(sent, received);
    EXPECT_EQ(got[0], 10 + other);
    EXPECT_EQ(got[1], 20 + other);
  });
}

TEST(Ranks, CallsOfAllRanksAgree) {
  on_ranks(3, [](Ranks& ranks) {
    const auto r = static_cast<uint32_t>(ranks.rank());
    EXPECT_EQ(values_of_all(ranks, r + 5), (std::vector<uint32_t>{5, 6, 7}));
    const uint32_t out[] = {10 * r, 10 * r + 1, 10 * r + 2};
    uint32_t in[3] = {};
    ranks.transpose(out, in);
    for (uint32_t k = 0; k < 3; ++k) EXPECT_EQ(in[k], 10 * k + r);
    uint64_t sums[] = {r, uint64_t{1} << 40};
    ranks.add_up(sums);
    EXPECT_EQ(sums[0], 3u);
    EXPECT_EQ(sums[1], uint64_t{3} << 40);
  });
}

TEST(Ranks, AFailureEndsTheCallsOfTheOthersAndNamesTheRank) {
  on_ranks(3, [](Ranks& ranks) {
    if (ranks.rank() == 2) return ranks.fail("out of paper");
    try {
      values_of_all(ranks, 0);
      ADD_FAILURE() << "the call has not ended";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::lost);
      EXPECT_STREQ(error.what(), "rank 2 failed: out of paper");
    }
  });
}

}  // namespace
}  // namespace meniscus::pbd
