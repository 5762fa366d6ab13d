// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Averages the times of the stages.
#include "sdk/viewer/stage_history.h"

namespace meniscus::viewer {

StageHistory::Means StageHistory::means() const {
  Means means;
  if (steps_.empty()) return means;
  const double share = 1 / static_cast<double>(steps_.size());
  for (const StepReport& step : steps_) {
    means.step += share * step.ms;
    for (std::size_t i = 0; i < stage_count; ++i) means.stages[i] += share * step.stage_ms[i];
  }
  return means;
}

}  // namespace meniscus::viewer
