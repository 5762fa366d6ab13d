// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the work that is done beside a run.
#include "sdk/cli/output/background.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/no_threads.h"

namespace meniscus::cli {
namespace {

using namespace std::chrono_literals;

TEST(Background, DoesEachTaskInOrder) {
  std::vector<int> done;
  {
    Background background(3);
    for (int i = 0; i < 100; ++i) {
      background.wait_for_room();
      background.add([&done, i] { done.push_back(i); });
    }
    background.finish();
    EXPECT_EQ(done.size(), 100u);
    background.add([&done] { done.push_back(100); });
  }
  ASSERT_EQ(done.size(), 101u) << "what is left is done at the end";
  for (int i = 0; i <= 100; ++i) EXPECT_EQ(done[static_cast<std::size_t>(i)], i);
}

TEST(Background, TheCallerWaitsWhenThereIsNoRoom) {
  Background background(2);
  std::atomic<bool> go = false;
  std::atomic<int> unfinished = 0, most = 0;
  std::thread later([&] {
    std::this_thread::sleep_for(20ms);
    go = true;
  });
  for (int i = 0; i < 6; ++i) {
    background.wait_for_room();
    most = std::max(most.load(), ++unfinished);
    background.add([&] {
      while (!go) std::this_thread::sleep_for(1ms);
      --unfinished;
    });
  }
  EXPECT_TRUE(go) << "the third task had to wait";
  background.finish();
  later.join();
  EXPECT_EQ(unfinished, 0);
  EXPECT_LE(most, 3) << "two, and one whose end was not yet noted";
}

TEST(Background, WhatATaskThrowsReachesTheCallerAndEndsTheWork) {
  int after = 0;
  Background background(3);
  background.add([] { throw std::runtime_error("the disk is full"); });
  const auto message = [&](const auto& call) {
    try {
      call();
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message([&] { background.finish(); }), "the disk is full");
  EXPECT_EQ(message([&] {
              background.wait_for_room();
              background.add([&] { ++after; });
            }),
            "the disk is full");
  EXPECT_EQ(after, 0);
}

TEST(Background, TheCallerDoesTheTasksWhenNoThreadCanStart) {
  std::vector<int> done;
  Background background(2);
  {
    const tests::NoThreads none;
    for (int i = 0; i < 4; ++i) {
      background.wait_for_room();
      background.add([&done, i] { done.push_back(i); });
      EXPECT_EQ(done.size(), static_cast<std::size_t>(i) + 1);
    }
    background.finish();
  }
  background.add([&done] { done.push_back(4); });  // by now there is a thread
  background.finish();
  EXPECT_EQ(done, (std::vector{0, 1, 2, 3, 4}));
  const tests::NoThreads none;
  Background another(2);
  another.add([] { throw std::runtime_error("the disk is full"); });
  another.add([&done] { done.push_back(5); });
  EXPECT_THROW(another.finish(), std::runtime_error);
  EXPECT_EQ(done.size(), 5u) << "nothing is done after a failure";
}

}  // namespace
}  // namespace meniscus::cli
