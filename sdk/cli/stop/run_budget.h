// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// When a command of many runs has to end: at a signal, or at a limit of time.
#pragma once

#include <chrono>
#include <string>

#include "sdk/cli/stop/interrupt.h"

namespace meniscus::cli {

/// Thrown between steps, where a command has to end and to write what it has.
struct Stopped {};

/// A limit on a command's wall clock, and the signals that end it. Only one may exist at a time.
class RunBudget {
 public:
  using Clock = std::chrono::steady_clock;

  /// `minutes`: from now on; 0: without limit.
  explicit RunBudget(double minutes);

  bool spent() const;
  bool interrupted() const { return interrupt_.raised(); }
  /// Why it is spent, as a sentence; empty if it is not.
  std::string reason() const;

  /// Steps of this world end early at a signal while the object exists.
  class Watch {
   public:
    Watch(RunBudget& budget, World& world) : budget_(budget) { budget_.interrupt_.watch(&world); }
    ~Watch() { budget_.interrupt_.watch(nullptr); }
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

   private:
    RunBudget& budget_;
  };

 private:
  Interrupt interrupt_;
  double minutes_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace meniscus::cli
