// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Chooses how many iterations of a step fit into a time: see WorldDef::step_budget_ms.
#pragma once

#include <meniscus/outputs.h>

#include <algorithm>
#include <cmath>

namespace meniscus {

/// The cost of a step is a + b·n, with n iterations. Both follow from the times of the last step. This is no
/// state of the world: it belongs to the machine.
class StepBudget {
 public:
  /// At most `most`, and at least one.
  int choose(double budget_ms, int most) const {
    if (!(budget_ms > 0) || iteration_ms_ <= 0) return most;
    const double fit = std::floor((budget_ms - other_ms_) / iteration_ms_);
    return static_cast<int>(std::clamp(fit, 1.0, static_cast<double>(most)));
  }
  /// `ms` is the wall clock time of the step without the caller's work in between.
  void note(const StepReport& report, double ms) {
    const double solve_ms = report.stage_ms[static_cast<std::size_t>(Stage::solve)];
    iteration_ms_ = solve_ms / report.iterations;
    other_ms_ = std::max(ms - solve_ms, 0.0);
  }

 private:
  double other_ms_ = 0, iteration_ms_ = 0;
};

}  // namespace meniscus
