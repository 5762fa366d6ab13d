// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The scenes of the paper at any size, and what stands in for meshes that are missing.
#pragma once

#include <string>

#include "sdk/cli/evidence/scene_run.h"
#include "sdk/cli/reproduce/reproduce.h"
#include "sdk/cli/stop/run_budget.h"
#include "sdk/io/report.h"

namespace meniscus::cli::pbf {

struct PaperScene {
  Scene scene;
  std::string stand_in;  ///< what replaces a mesh, as a sentence; empty: nothing
};

/// What each part works with.
struct Context {
  const ReproduceOptions& options;
  RunBudget& budget;
  io::Report& report;

  /// A sample without spray, its spacing chosen for the options' number of particles. Throws Error.
  PaperScene scene(const std::string& sample) const;
  RunFigures run(const std::string& name, const Scene& scene, bool measured = true) const;
};

/// The setting "substeps × iterations".
std::string setting_of(const Scene& scene);
Scene with_setting(Scene scene, int substeps, int iterations);
/// PCISPH with the fixed substeps of its paper, in place of the density constraint. It takes no artificial
/// pressure.
Scene with_pcisph(Scene scene, int substeps, int iterations);

/// Calls `add` for each item until the budget is spent. Returns whether all were done.
template <class Items, class Add>
bool for_each_until_stopped(const Items& items, const Add& add) {
  try {
    for (const auto& item : items) add(item);
    return true;
  } catch (const Stopped&) {
    return false;
  }
}

}  // namespace meniscus::cli::pbf
