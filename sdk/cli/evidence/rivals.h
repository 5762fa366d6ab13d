// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The density solvers as rivals: the time of each at equal mean density error, and its largest stable step.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "sdk/cli/evidence/stable_step.h"
#include "sdk/fields/names.h"

namespace meniscus::cli {

/// The most iterations of a substep. They are enough for each solver to reach the errors that are asked for.
inline constexpr int most_rival_iterations = 100;

struct Rival {
  std::string solver;
  double target;                                         ///< %
  double ms = std::numeric_limits<double>::quiet_NaN();  ///< for a simulated second
  double error = 0;                                      ///< %, mean over the run
  double substeps = 0;                                   ///< of a frame, mean
  double iterations = 0;                                 ///< of a substep, mean
  double bytes = 0;                                      ///< of a particle
  std::string failure{};
};

/// Runs a scene of fluids and bodies with a solver at a mean density error of `target` percent. Of all these
/// numbers of substeps a frame, the fastest that reaches the error counts; empty: the scene's own number.
/// Throws Stopped, and Error for what is no result of the run.
Rival rival_at(const Scene& scene, const Named<DensitySolver>& solver, double target, double seconds,
               const std::vector<int>& substeps, RunBudget& budget);

/// The largest stable step at a mean density error of 1 %. Throws likewise.
StableStep stable_step_of(const Scene& scene, DensitySolver solver, double seconds,
                          const StableBounds& bounds, RunBudget& budget);

/// The scene with a solver at a mean density error, as a fraction. What no solver but the density constraint
/// has is left out for all.
Scene rival_scene(Scene scene, DensitySolver solver, double error);

}  // namespace meniscus::cli
