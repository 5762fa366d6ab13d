// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The times of the stages in the last steps.
#pragma once

#include <meniscus/outputs.h>

#include <array>
#include <deque>

namespace meniscus::viewer {

/// The times of the stages in the last steps.
class StageHistory {
 public:
  static constexpr std::size_t most_steps = 180;

  void clear() { steps_.clear(); }
  void add(const StepReport& report) {
    steps_.push_back(report);
    if (steps_.size() > most_steps) steps_.pop_front();
  }
  const std::deque<StepReport>& steps() const { return steps_; }

  /// Means over the stored steps, ms.
  struct Means {
    double step = 0;
    std::array<double, stage_count> stages{};
  };
  Means means() const;

 private:
  std::deque<StepReport> steps_;
};

}  // namespace meniscus::viewer
