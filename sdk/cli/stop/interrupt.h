// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Turns SIGINT and SIGTERM into a flag that a run can poll.
#pragma once

#include <meniscus/world.h>

#include <csignal>

namespace meniscus::cli {

/// While an object of this class exists, the first SIGINT or SIGTERM sets a flag and cancels the long call of
/// the watched world, so that a loop can end in good order. The second ends the program at once. Only one may
/// exist at a time.
class Interrupt {
 public:
  Interrupt();
  explicit Interrupt(World& world);
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  bool raised() const;
  /// The world whose calls are cancelled from now on; null: none. A world must outlive its watch.
  void watch(World* world);

 private:
  struct sigaction old_int_ {
  }, old_term_{};
};

}  // namespace meniscus::cli
