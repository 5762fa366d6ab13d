// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <csignal>

namespace meniscus::cli {

/// While one lives, the first SIGINT or SIGTERM only raises a flag, so that a loop can end in good order. The
/// second ends the program at once. One at a time.
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
