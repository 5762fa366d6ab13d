// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Runs density solvers at equal mean density error, and searches for their stable steps.
#include "sdk/cli/evidence/rivals.h"

#include <algorithm>
#include <cmath>

#include "pbd/math/vec.h"
#include "sdk/fields/world.h"

namespace meniscus::cli {
namespace {

constexpr int least_iterations = 3;  // PCISPH's
constexpr int first_allowed_iterations = 8;

/// A run reaches an error if its mean is at most this times what was asked for.
constexpr double reached = 1.2;

/// The error at which stable steps are searched for.
constexpr double error_of_search = 0.01;

/// WCSPH has no tolerance. A column of the fluid's depth H at rest has the mean error ρ g H κ/2.
void soften_wcsph(World& world, float density, double error) {
  WorldDef def = world.def();
  const Heights heights = heights_of(world);
  const double depth = std::max(heights.high - heights.low, double{def.particle_spacing});
  const double pressure = double{density} * double{length(def.gravity)} * depth;
  if (pressure > 0) def.density.compressibility = static_cast<float>(2 * error / pressure);
  world.set_def(def);
}

RunRequest request_of(const Scene& chosen, DensitySolver solver, double seconds, double error) {
  RunRequest request{.name = "", .scene = chosen, .seconds = seconds};
  if (solver == DensitySolver::wcsph)
    request.before = [&chosen, error](World& world) {
      soften_wcsph(world, chosen.fluids.front().rest_density, error);
    };
  return request;
}

/// Ends a run also where it is lost, and then says why. The substeps of a solver that is bound to the speed
/// of its particles would go on for very long.
RunFigures run_unless_lost(RunRequest request, RunBudget& budget) {
  const StableBounds bounds;
  const auto ends = request.ends;
  request.ends = [&](const RunFigures& so_far) { return is_lost(so_far, bounds) || (ends && ends(so_far)); };
  RunFigures run = run_figures(request, budget);
  if (is_lost(run, bounds)) run.failure = broken_by(run, bounds);
  return run;
}

int needed_iterations(const RunFigures& run) {
  return static_cast<int>(std::ceil(largest_of(run.iterations))) + 1;
}

/// A run that shows how many iterations the solver needs. Contacts are solved in as many as are allowed,
/// which takes time. So few are allowed first, and twice as many after each run in which they were too few.
RunFigures trial_run(Scene chosen, DensitySolver solver, double seconds, double error, RunBudget& budget) {
  for (int allowed = first_allowed_iterations;; allowed = std::min(2 * allowed, most_rival_iterations)) {
    chosen.world.iterations = allowed;
    RunRequest request = request_of(chosen, solver, seconds, error);
    request.ends = [&](const RunFigures& so_far) { return needed_iterations(so_far) > allowed; };
    const bool is_last = allowed == most_rival_iterations;
    if (is_last) request.ends = {};
    const RunFigures run = run_unless_lost(request, budget);
    if (is_last || (run.failure.empty() && needed_iterations(run) <= allowed)) return run;
  }
}

/// A first run finds how many iterations the solver needs, and a second one is timed.
RunFigures timed_run(Scene chosen, DensitySolver solver, double seconds, double error, RunBudget& budget) {
  if (solver != DensitySolver::wcsph) {
    const RunFigures trial = trial_run(chosen, solver, seconds, error, budget);
    if (!trial.failure.empty()) return trial;
    chosen.world.iterations = std::clamp(needed_iterations(trial), least_iterations, most_rival_iterations);
  }
  return run_unless_lost(request_of(chosen, solver, seconds, error), budget);
}

Rival rival_of(const RunFigures& run, const Scene& scene, const char* solver, double target) {
  Rival rival{solver, target};
  rival.failure = run.failure;
  if (!run.failure.empty()) return rival;
  rival.ms = mean_of(run.ms) / double{scene.frame_time};
  rival.error = 100 * mean_of(run.error_mean);
  rival.substeps = mean_of(run.substeps);
  rival.iterations = mean_of(run.iterations);
  rival.bytes = run.bytes;
  return rival;
}

bool is_better(const Rival& a, const Rival& b) {
  if (!a.failure.empty() || !b.failure.empty()) return a.failure.empty() && !b.failure.empty();
  const bool a_reached = a.error <= reached * a.target, b_reached = b.error <= reached * b.target;
  if (a_reached != b_reached) return a_reached;
  return a_reached ? a.ms < b.ms : a.error < b.error;
}

}  // namespace

Scene rival_scene(Scene scene, DensitySolver solver, double error) {
  WorldDef& def = scene.world;
  def.density.solver = solver;
  def.density.artificial_pressure = {};
  def.density.compressibility = 0;
  def.density.tolerance = solver == DensitySolver::wcsph ? 0 : static_cast<float>(error);
  def.diffuse.reset();
  return scene;
}

Rival rival_at(const Scene& scene, const Named<DensitySolver>& solver, double target, double seconds,
               const std::vector<int>& substeps, RunBudget& budget) {
  std::vector<int> tried = substeps;
  if (tried.empty()) tried.push_back(scene.world.substeps);
  std::vector<Rival> results;
  for (const int count : tried) {
    Scene chosen = rival_scene(scene, solver.value, target / 100);
    if (!substeps.empty()) chosen.world.cfl_number = 0;
    chosen.world.substeps = count;
    const RunFigures run = timed_run(chosen, solver.value, seconds, target / 100, budget);
    results.push_back(rival_of(run, scene, solver.name, target));
  }
  return *std::min_element(results.begin(), results.end(), is_better);
}

StableStep stable_step_of(const Scene& scene, DensitySolver solver, double seconds,
                          const StableBounds& bounds, RunBudget& budget) {
  const auto run = [&](double step) {
    Scene chosen = rival_scene(scene, solver, error_of_search);
    chosen.frame_time = static_cast<float>(step);
    chosen.world.substeps = 1;
    chosen.world.cfl_number = 0;
    chosen.world.iterations = most_rival_iterations;
    RunRequest request = request_of(chosen, solver, seconds, error_of_search);
    request.ends = [&](const RunFigures& so_far) { return is_lost(so_far, bounds); };
    return run_figures(request, budget);
  };
  return find_stable_step({}, bounds, run);
}

}  // namespace meniscus::cli
