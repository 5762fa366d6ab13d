// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <meniscus/outputs.h>

#include <array>
#include <deque>

namespace meniscus::viewer {

/// What the stages of the last steps took.
class StageHistory {
 public:
  static constexpr std::size_t most_steps = 180;

  void clear() { steps_.clear(); }
  void add(const StepReport& report) {
    steps_.push_back(report);
    if (steps_.size() > most_steps) steps_.pop_front();
  }
  const std::deque<StepReport>& steps() const { return steps_; }

  /// ms, means over the steps kept.
  struct Means {
    double step = 0;
    std::array<double, stage_count> stages{};
  };
  Means means() const;

 private:
  std::deque<StepReport> steps_;
};

}  // namespace meniscus::viewer
