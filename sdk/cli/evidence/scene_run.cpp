// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Runs a scene and keeps its figures, frame by frame.
#include "sdk/cli/evidence/scene_run.h"

#include <meniscus/error.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "pbd/math/vec.h"

namespace meniscus::cli {
namespace {

/// Particles that may be thrown up: a splash has single drops at any height.
constexpr double thrown_share = 0.001;

/// What a run's figures are relative to.
struct Start {
  Heights heights;
  double height;     ///< m
  double total;      ///< J
  double available;  ///< J: at most this becomes free if all falls to the lowest particle

  explicit Start(const BuiltScene& built) : heights(heights_of(built.world)) {
    const World& world = built.world;
    const Diagnostics first = world.diagnostics();
    height = std::max(heights.high - heights.low, double{world.def().particle_spacing});
    total = first.kinetic_energy + first.potential_energy;
    double mass = 0, sum = 0;
    const Vec3 up = normalized_or(-world.def().gravity, {0, 1, 0});
    const auto positions = world.positions();
    const auto fluids = world.fluids();
    std::vector<double> masses;
    for (const FluidId fluid : built.fluids) masses.push_back(double{world.particle_mass(fluid)});
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const double m = masses.at(fluids[i]);
      mass += m;
      sum += m * (double{dot(positions[i], up)} - heights.low);
    }
    available = std::max(sum * double{length(world.def().gravity)} + first.kinetic_energy, 1e-12 * mass);
  }
};

void measure(const World& world, const Start& start, RunFigures& run) {
  const Diagnostics now = world.diagnostics();
  const auto errors = world.density_errors();
  run.time.push_back(world.time());
  run.error_mean.push_back(now.density_error_mean);
  run.error_max.push_back(now.density_error_max);
  run.density_mean.push_back(std::accumulate(errors.begin(), errors.end(), 0.0) /
                             static_cast<double>(std::max<std::size_t>(errors.size(), 1)));
  run.kinetic.push_back(now.kinetic_energy);
  const double total = now.kinetic_energy + now.potential_energy;
  run.gain = std::max(run.gain, (total - start.total) / start.available);
  run.rise = std::max(run.rise, (height_exceeded_by(thrown_share, world) - start.heights.low) / start.height);
  run.outside = std::max(run.outside, now.outside);
}

void step(World& world, const RunRequest& request, int frame, RunFigures& run) {
  const StepReport report = world.step(request.scene.frame_time);
  run.ms.push_back(report.ms);
  run.substeps.push_back(report.substeps);
  run.iterations.push_back(report.density_iterations);
  for (std::size_t s = 0; s < stage_count; ++s) run.stage_ms[s] += report.stage_ms[s];
  if (request.after) request.after(world, frame);
}

/// Whether an error is a result of the run.
bool is_result(const Error& error) {
  return error.code() == ErrorCode::non_finite || error.code() == ErrorCode::out_of_memory;
}

}  // namespace

Heights heights_of(const World& world) {
  const Vec3 up = normalized_or(-world.def().gravity, {0, 1, 0});
  Heights heights{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
  for (Vec3 p : world.positions()) {
    heights.low = std::min(heights.low, double{dot(p, up)});
    heights.high = std::max(heights.high, double{dot(p, up)});
  }
  return heights;
}

double height_exceeded_by(double share, const World& world) {
  const Vec3 up = normalized_or(-world.def().gravity, {0, 1, 0});
  std::vector<double> heights;
  for (Vec3 p : world.positions()) heights.push_back(double{dot(p, up)});
  if (heights.empty()) return 0;
  const auto above = static_cast<std::size_t>(share * static_cast<double>(heights.size()));
  const auto at = heights.begin() + static_cast<std::ptrdiff_t>(std::min(above, heights.size() - 1));
  std::nth_element(heights.begin(), at, heights.end(), std::greater<>{});
  return *at;
}

double mean_of(const std::vector<double>& values) {
  if (values.empty()) return 0;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double largest_of(const std::vector<double>& values) {
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

double median_of(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

int frames_of(const Scene& scene, double seconds) {
  return std::max(1, static_cast<int>(std::lround(seconds / double{scene.frame_time})));
}

RunFigures run_figures(const RunRequest& request, RunBudget& budget) {
  RunFigures run;
  run.name = request.name;
  if (budget.spent()) throw Stopped{};
  try {
    BuiltScene built = build_scene(request.scene);
    World& world = built.world;
    const RunBudget::Watch watch(budget, world);
    if (request.before) request.before(world);
    run.particles = world.particle_count();
    const Start start(built);
    const int frames = frames_of(request.scene, request.seconds);
    for (int frame = 1; frame <= frames; ++frame) {
      if (budget.spent()) throw Stopped{};
      step(world, request, frame, run);
      if (request.measured || frame == frames) measure(world, start, run);
      if (request.ends && request.ends(run)) break;
    }
    run.bytes = static_cast<double>(world.device_bytes()) /
                static_cast<double>(std::max<std::size_t>(1, run.particles));
  } catch (const Error& error) {
    if (error.code() == ErrorCode::cancelled) throw Stopped{};
    if (!is_result(error)) throw;
    run.failure = error.what();
  }
  return run;
}

}  // namespace meniscus::cli
