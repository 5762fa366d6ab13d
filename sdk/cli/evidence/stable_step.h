// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What counts as a stable run, and the search for the largest stable step.
#pragma once

#include <functional>
#include <string>

#include "sdk/cli/evidence/scene_run.h"

namespace meniscus::cli {

/// The bounds of a stable run. It ends with finite values, and no particle leaves a container.
struct StableBounds {
  double error = 0.05;  ///< mean over the run of the mean of max(C, 0)
  double rise = 3;      ///< height that one particle in a thousand exceeds, over the fluid's first height
  double gain = 0.1;    ///< of energy, over what falling can set free
};

/// The bounds in words, for a page.
std::string sentence_of(const StableBounds& bounds);

/// Which bound the run breaks, in a few words; empty if none.
std::string broken_by(const RunFigures& run, const StableBounds& bounds);

/// Whether the run is beyond a bound that later frames cannot mend.
bool is_lost(const RunFigures& run, const StableBounds& bounds);

struct StepSearch {
  double longest = 0.128, shortest = 0.0005;  ///< s
  int bisections = 2;                         ///< between the last step that broke and the first that held
};

struct StableStep {
  double asked = 0;      ///< s, the longest that held; 0: none
  double made = 0;       ///< s, the mean substep of that run
  double broke = 0;      ///< s, the shortest that broke above it; 0: none
  std::string reason{};  ///< why that one broke
  int runs = 0;
};

/// Halves the step from the longest one until a run holds, and then bisects its logarithm. `run` runs steps
/// of this length, each one substep.
StableStep find_stable_step(const StepSearch& search, const StableBounds& bounds,
                            const std::function<RunFigures(double step)>& run);

}  // namespace meniscus::cli
