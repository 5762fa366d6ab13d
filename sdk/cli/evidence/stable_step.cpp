// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Judges runs, and searches for the largest stable step.
#include "sdk/cli/evidence/stable_step.h"

#include <spdlog/fmt/fmt.h>

#include <cmath>

namespace meniscus::cli {

std::string sentence_of(const StableBounds& b) {
  return fmt::format(
      "A run is stable within these bounds. All values stay finite, and no particle leaves the container. "
      "At most one in a thousand rises above {:g} times the fluid's first height. The mean density error "
      "over the run is at most {:g} %. The "
      "energy "
      "gains at most {:g} % of what falling can set free.",
      b.rise, 100 * b.error, 100 * b.gain);
}

std::string broken_by(const RunFigures& run, const StableBounds& bounds) {
  if (!run.failure.empty()) return "values that are not finite, or no memory";
  if (run.outside > 0) return fmt::format("{} particles outside", run.outside);
  if (!(run.rise <= bounds.rise)) return fmt::format("rises to {:.3g} heights", run.rise);
  if (!(run.gain <= bounds.gain)) return fmt::format("gains {:.3g} % of energy", 100 * run.gain);
  const double error = mean_of(run.error_mean);
  if (!(error <= bounds.error)) return fmt::format("mean density error {:.3g} %", 100 * error);
  return "";
}

bool is_lost(const RunFigures& run, const StableBounds& bounds) {
  return run.outside > 0 || !(run.rise <= bounds.rise) || !(run.gain <= bounds.gain);
}

StableStep find_stable_step(const StepSearch& search, const StableBounds& bounds,
                            const std::function<RunFigures(double)>& run) {
  StableStep found;
  const auto holds = [&](double step) {
    const RunFigures figures = run(step);
    const std::string reason = broken_by(figures, bounds);
    ++found.runs;
    if (reason.empty()) {
      found.asked = step;
      found.made = step / std::max(1.0, mean_of(figures.substeps));
    } else {
      found.broke = step;
      found.reason = reason;
    }
    return reason.empty();
  };
  for (double step = search.longest; step >= search.shortest * 0.999; step /= 2) {
    if (holds(step)) break;
  }
  if (found.asked == 0 || found.broke == 0) return found;
  for (int k = 0; k < search.bisections; ++k) holds(std::sqrt(found.asked * found.broke));
  return found;
}

}  // namespace meniscus::cli
