// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Memory that runs out on the host is an error, and the world is as before or says that it is lost.
#include "tests/faults/memory_faults.h"

namespace meniscus::tests {
namespace {

class FaultsTest : public OnDevice {
 protected:
  void SetUp() override { forget_stacks(); }

  static void report(const FaultRun& run) {
    RecordProperty("failures", run.counts().failures);
    RecordProperty("losses", run.counts().losses);
    std::printf("%d failures, of which %d lost the world\n", run.counts().failures, run.counts().losses);
    for (const auto& [call, times] : run.losses()) std::printf("  %s: %d\n", call.c_str(), times);
  }
};

TEST_P(FaultsTest, AFailureAtAnyCallStackIsAnError) {
  FaultRun run(GetParam(), 2);
  run.run_without_failures();
  run.run(0, false);
  EXPECT_GT(run.counts().failures, 300);
  report(run);
}

TEST_P(FaultsTest, NoMemoryFromAnyCallStackOnIsAnError) {
  FaultRun run(GetParam(), 2);
  run.run_without_failures();
  run.run(0, true);
  EXPECT_GT(run.counts().failures, 300);
  report(run);
}

TEST_P(FaultsTest, EveryFiftiethAllocationIsAnErrorLong) {
  for (const bool and_all_after : {false, true}) {
    FaultRun run(GetParam(), 12);
    run.run_without_failures();
    run.run(50, and_all_after);
    report(run);
  }
}

MENISCUS_ON_EACH_DEVICE(FaultsTest);

}  // namespace
}  // namespace meniscus::tests
