// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Runs a scene and keeps its figures, frame by frame.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <meniscus/scene.h>
#include "sdk/cli/stop/run_budget.h"

namespace meniscus::cli {

/// One value a frame, unless it says otherwise.
struct RunFigures {
  std::string name;
  std::size_t particles = 0;
  std::vector<double> ms;                      ///< of the step
  std::vector<double> substeps;                ///< made
  std::vector<double> iterations;              ///< of the density, a substep
  std::array<double, stage_count> stage_ms{};  ///< sums over the run
  double bytes = 0;                            ///< on the device, a particle
  std::string failure;                         ///< what ended the run early; empty: nothing did

  // Measured where that is asked for:
  std::vector<double> time;          ///< s
  std::vector<double> error_mean;    ///< mean of max(C, 0), a fraction
  std::vector<double> error_max;     ///< largest C, a fraction
  std::vector<double> density_mean;  ///< mean of C with the deficit of the surface, a fraction
  std::vector<double> kinetic;       ///< J
  double gain = 0;  ///< largest total energy over the first one, of what falling can set free
  double rise = 0;  ///< greatest height that one particle in a thousand exceeds, over the fluid's first
  std::size_t outside = 0;  ///< most particles at once beyond a wall
};

double mean_of(const std::vector<double>& values);     ///< 0 without any
double largest_of(const std::vector<double>& values);  ///< likewise
double median_of(std::vector<double> values);          ///< likewise

/// m, the lowest and the highest particle along gravity.
struct Heights {
  double low = 0, high = 0;
};
Heights heights_of(const World& world);
/// m, the height along gravity that this share of the particles exceeds, 0 to 1.
double height_exceeded_by(double share, const World& world);

struct RunRequest {
  std::string name;
  const Scene& scene;
  double seconds = 1;
  bool measured = true;                                  ///< after each frame; or times alone
  std::function<void(World&)> before{};                  ///< at the built world
  std::function<void(const World&, int frame)> after{};  ///< each frame, from 1 on
  std::function<bool(const RunFigures&)> ends{};         ///< whether what was measured so far is enough
};

/// How many frames fill this time, at least 1.
int frames_of(const Scene& scene, double seconds);

/// Runs the request. A state that is not finite and a lack of memory end the run, and are its `failure`.
/// Throws Stopped if the budget is spent, and Error for all else.
RunFigures run_figures(const RunRequest& request, RunBudget& budget);

}  // namespace meniscus::cli
