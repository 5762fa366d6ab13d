// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Turns SIGINT and SIGTERM into a flag that a run can poll.
#pragma once

#include <csignal>

namespace meniscus::cli {

/// While an object of this class exists, the first SIGINT or SIGTERM only sets a flag, so that a loop can end
/// in good order. The second ends the program at once. Only one may exist at a time.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  bool raised() const;

 private:
  struct sigaction old_int_ {
  }, old_term_{};
};

}  // namespace meniscus::cli
