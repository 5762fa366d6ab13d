// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Memory that runs out while output is written is an error, and leaves no half file.
#include <exception>
#include <optional>

#include "tests/faults/failing_memory.h"
#include "tests/faults/program_runs.h"

namespace meniscus::tests {
namespace {

class OutputFaults : public ProgramRuns {
 protected:
  /// Makes every stride-th allocation of a run fail, alone or with all that follow.
  void lose_memory(uint64_t stride) {
    ASSERT_EQ(end_of_good_run(), 0);
    const auto good = files();
    ASSERT_GT(good.size(), 10u);
    for (const bool and_all_after : {false, true}) {
      std::map<int, int> ends;
      for (uint64_t number = 1;; number += stride) {
        SCOPED_TRACE("allocation " + std::to_string(number));
        fs::remove_all(out());
        const int end = end_of_run_without({number, and_all_after});
        if (end == without_failure || HasFailure()) break;
        ++ends[end];
        EXPECT_TRUE(end == 0 || end == cli::run_failed || end == no_memory_to_destroy) << end;
        expect_no_half_file(good, end == no_memory_to_destroy);
      }
      for (const auto& [end, times] : ends) std::printf("exit code %d: %d times\n", end, times);
      EXPECT_GT(ends[cli::run_failed], 3);
    }
  }

 private:
  int end_of_run_without(const FailureChoice& choice) const {
    std::optional<FailingMemory> failing;
    return end_of_run(
        [&] {
          std::set_terminate([] { std::_Exit(no_memory_to_destroy); });
          failing.emplace(choice);
        },
        [&](int code) { return failing->has_failed() ? code : without_failure; });
  }

  static constexpr int without_failure = 77, no_memory_to_destroy = 78;
};

/// Each failure in a process of its own: the JSON library ends it where its destructors lack memory.
TEST_F(OutputFaults, ARunThatLosesMemoryLeavesNoHalfFile) {
  lose_memory(1499);
}

TEST_F(OutputFaults, ARunThatLosesMemoryAnywhereLeavesNoHalfFileLong) {
  lose_memory(97);
}

}  // namespace
}  // namespace meniscus::tests
