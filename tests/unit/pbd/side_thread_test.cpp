// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Threads: the order of tasks, failures, and what happens where none can be started.
#include "pbd/device/side_thread.h"

#include <gtest/gtest.h>

#include <sys/resource.h>

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "pbd/device/cpu/cpu_device.h"
#include "pbd/device/cpu/plain_threads.h"
#include "tests/expect_error.h"
#include "tests/no_threads.h"

namespace meniscus::pbd {
namespace {

TEST(SideThread, TasksRunInOrderUntilOneFails) {
  SideThread side;
  std::vector<int> ran;
  for (int i = 0; i < 3; ++i) side.run([&ran, i] { ran.push_back(i); });
  side.wait();
  EXPECT_EQ(ran, (std::vector<int>{0, 1, 2}));
  side.run([] { throw std::runtime_error("no"); });
  side.run([&ran] { ran.push_back(3); });
  EXPECT_THROW(side.wait(), std::runtime_error);
  side.run([&ran] { ran.push_back(4); });
  side.wait();
  EXPECT_EQ(ran, (std::vector<int>{0, 1, 2, 4}));
}

TEST(SideThread, ATaskWithoutAThreadIsRefusedAndNotWaitedFor) {
  SideThread side;
  int ran = 0;
  {
    const tests::NoThreads none;
    for (int i = 0; i < 2; ++i) {
      tests::expect_error(ErrorCode::out_of_memory, "could not be started",
                          [&] { side.run([&ran] { ++ran; }); });
      side.wait();
    }
  }
  EXPECT_EQ(ran, 0);
  side.run([&ran] { ++ran; });
  side.wait();
  EXPECT_EQ(ran, 1);
}

TEST(PlainThreads, AllPiecesRunOrTheFailureIsReported) {
  std::atomic<uint32_t> sum{0};
  const auto body = [&sum](uint32_t begin, uint32_t end) { sum += end - begin; };
  run_on_plain_threads(3, 10, body);
  EXPECT_EQ(sum, 10u);
  const tests::NoThreads none;
  tests::expect_error(ErrorCode::out_of_memory, "could not be started",
                      [&] { run_on_plain_threads(3, 10, body); });
  EXPECT_EQ(sum, 10u);
}

/// Leaves the process this much address space, in bytes, on top of what it has.
void limit_memory(size_t more) {
  size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const rlim_t most = pages * 4096 + more;
  const rlimit limit{most, most};
  setrlimit(RLIMIT_AS, &limit);
}

[[noreturn]] void make_a_device_in_little_memory(int threads) {
  limit_memory(size_t{64} << 20);
  try {
    const CpuDevice device(threads);
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    std::_Exit(error.code() == ErrorCode::out_of_memory ? 1 : 2);
  }
  std::_Exit(0);
}

TEST(CpuDevice, ThreadsForWhichThereIsNoRoomAreRefusedAtOnce) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(make_a_device_in_little_memory(2), testing::ExitedWithCode(0), "^$");
  EXPECT_EXIT(make_a_device_in_little_memory(200), testing::ExitedWithCode(1), "of the 200 threads");
}

}  // namespace
}  // namespace meniscus::pbd
