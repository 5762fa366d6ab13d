// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Repeats a call until each of its allocations has failed.
#pragma once

#include <gtest/gtest.h>
#include <meniscus/error.h>

#include "tests/faults/failing_memory.h"

namespace meniscus::tests {

/// Calls until no call stack is left whose allocation has not failed. `look(failed, succeeded)` follows each
/// call. Returns the number of failures. The call may only throw Error(out_of_memory).
template <class Call, class Look>
int fail_everywhere(const Call& call, const Look& look) {
  for (int failures = 0;; ++failures) {
    bool fails = false, succeeds = true;
    try {
      const FailingMemory failing({});
      try {
        call();
      } catch (...) {
        fails = failing.has_failed();
        throw;
      }
      fails = failing.has_failed();
    } catch (const Error& error) {
      succeeds = false;
      EXPECT_EQ(static_cast<int>(error.code()), static_cast<int>(ErrorCode::out_of_memory)) << error.what();
    } catch (const std::exception& error) {
      succeeds = false;
      ADD_FAILURE() << error.what();
    }
    look(fails, succeeds);
    if (testing::Test::HasFailure()) print_last_stack();
    if (!fails || testing::Test::HasFailure()) return failures;
  }
}

template <class Call>
int fail_everywhere(const Call& call) {
  return fail_everywhere(call, [](bool, bool) {});
}

}  // namespace meniscus::tests
