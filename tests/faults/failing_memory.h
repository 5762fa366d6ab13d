// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Makes chosen allocations of this program fail: those of operator new, and of the CPU device.
#pragma once

#include <cstdint>

namespace meniscus::tests {

/// What fails while a FailingMemory lives.
struct FailureChoice {
  /// 0: the first allocation whose call stack has not failed yet in this process. Else: the allocation of
  /// this number, from 1 on.
  uint64_t number = 0;
  bool and_all_after = false;  ///< the memory is used up, rather than one request too large
};

class FailingMemory {
 public:
  explicit FailingMemory(const FailureChoice& choice);
  ~FailingMemory();
  FailingMemory(const FailingMemory&) = delete;
  FailingMemory& operator=(const FailingMemory&) = delete;

  /// Whether an allocation has failed so far.
  bool has_failed() const;
};

/// Forgets which call stacks have failed.
void forget_stacks();
/// Prints the call stack of the last failure, for those who look for its cause.
void print_last_stack();

}  // namespace meniscus::tests
