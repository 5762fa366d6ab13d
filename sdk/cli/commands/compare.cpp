// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Implements `meniscus compare`: the density solvers at equal mean density error.
#include "sdk/cli/commands/compare.h"

#include <meniscus/error.h>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "pbd/math/vec.h"
#include "sdk/cli/commands/exit_code.h"
#include "sdk/cli/output/frame_exporter.h"
#include "sdk/cli/record/json_text.h"
#include "sdk/fields/world.h"
#include "sdk/io/line_chart.h"
#include "sdk/io/output_file.h"

namespace meniscus::cli {
namespace {

using json = nlohmann::ordered_json;

/// The most iterations of a substep: enough for each solver to reach the errors that are asked for. And the
/// fewest: PCISPH's.
constexpr int most_iterations = 100, least_iterations = 3;

struct Rival {
  const char* solver;
  double target;                                         // %
  double ms = std::numeric_limits<double>::quiet_NaN();  // for a simulated second
  double error = 0, substeps = 0, iterations = 0;        // means: %; of a frame; of a substep
  double longest = 0;                                    // iterations of a substep, mean of a frame
  double bytes = 0;                                      // of a particle
  std::string failure{};
};

/// m, along gravity.
float depth_of(const World& world) {
  const Vec3 up = normalized_or(-world.def().gravity, {0, 1, 0});
  float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
  for (Vec3 p : world.positions()) {
    low = std::min(low, dot(p, up));
    high = std::max(high, dot(p, up));
  }
  return std::max(high - low, world.def().particle_spacing);
}

/// WCSPH has no tolerance. A column of the fluid's depth H at rest has the mean error ρ g H κ/2.
void soften_wcsph(World& world, float density, double error) {
  WorldDef def = world.def();
  const double pressure = double{density} * double{length(def.gravity)} * double{depth_of(world)};
  if (pressure > 0) def.density.compressibility = static_cast<float>(2 * error / pressure);
  world.set_def(def);
}

/// What no solver but the density constraint has is left out for all of them.
Scene prepared(Scene scene, DensitySolver solver, double error) {
  WorldDef& def = scene.world;
  def.density.solver = solver;
  def.density.artificial_pressure = {};
  def.density.compressibility = 0;
  def.density.tolerance = solver == DensitySolver::wcsph ? 0 : static_cast<float>(error);
  def.diffuse.reset();
  return scene;
}

/// With this many iterations at most; 0: as many as the scene has.
void run(const Scene& scene, Rival& rival, DensitySolver solver, double seconds, int iterations) {
  const double error = rival.target / 100;
  Scene chosen = prepared(scene, solver, error);
  if (iterations > 0) chosen.world.iterations = iterations;
  BuiltScene built = build_scene(chosen);
  World& world = built.world;
  if (solver == DensitySolver::wcsph) soften_wcsph(world, scene.fluids.front().rest_density, error);
  const int frames = std::max(1, static_cast<int>(std::lround(seconds / double{scene.frame_time})));
  double ms = 0;
  for (int k = 0; k < frames; ++k) {
    const StepReport step = world.step(scene.frame_time);
    ms += step.ms;
    rival.error += 100 * world.diagnostics().density_error_mean / frames;
    rival.substeps += double(step.substeps) / frames;
    rival.iterations += step.density_iterations / frames;
    rival.longest = std::max(rival.longest, step.density_iterations);
  }
  rival.ms = ms / (frames * double{scene.frame_time});
  rival.bytes = static_cast<double>(world.device_bytes()) /
                static_cast<double>(std::max<std::size_t>(1, world.particle_count()));
}

/// A run that fails is a result. Contacts are solved in as many iterations as are allowed, so a first run
/// finds how many a solver needs, and a second one is timed.
Rival result_of(const Scene& scene, const Named<DensitySolver>& solver, double target, double seconds) {
  Rival rival{solver.name, target};
  try {
    if (solver.value == DensitySolver::wcsph) {
      run(scene, rival, solver.value, seconds, 0);
    } else {
      Rival trial = rival;
      run(scene, trial, solver.value, seconds, most_iterations);
      const int needed = static_cast<int>(std::ceil(trial.longest)) + 1;
      run(scene, rival, solver.value, seconds, std::clamp(needed, least_iterations, most_iterations));
    }
  } catch (const Error& error) {
    if (error.code() != ErrorCode::non_finite && error.code() != ErrorCode::out_of_memory) throw;
    rival.failure = error.what();
  }
  return rival;
}

constexpr const char* header =
    "| solver | error asked for, % | error, % | ms for a second | substeps a frame | iterations a substep | "
    "bytes a particle |\n|---|---|---|---|---|---|---|\n";

std::string row(const Rival& r) {
  if (!r.failure.empty()) return fmt::format("| {} | {} | {} |||||\n", r.solver, r.target, r.failure);
  return fmt::format("| {} | {} | {:.3g} | {:.4g} | {:.1f} | {:.1f} | {:.0f} |\n", r.solver, r.target,
                     r.error, r.ms, r.substeps, r.iterations, r.bytes);
}

json figures_of(const Rival& r) {
  json figures{{"solver", r.solver}, {"error_asked_percent", r.target}};
  if (!r.failure.empty()) {
    figures["failure"] = r.failure;
    return figures;
  }
  figures["error_percent"] = r.error;
  figures["ms_per_second"] = r.ms;
  figures["substeps"] = r.substeps;
  figures["iterations"] = r.iterations;
  figures["bytes_per_particle"] = r.bytes;
  return figures;
}

std::string chart_of(const std::string& title, const std::vector<double>& errors,
                     const std::vector<Rival>& rivals) {
  constexpr std::array colors{"#888888", "#1f77b4", "#17becf", "#d62728", "#ff7f0e", "#2ca02c"};
  io::LineChart chart{title, "mean density error asked for, %", errors, {{"ms for a second", {}}}};
  for (const Rival& rival : rivals) {
    std::vector<io::ChartSeries>& series = chart.panels.front().series;
    if (series.empty() || series.back().name != rival.solver)
      series.push_back({rival.solver, colors[series.size() % colors.size()], {}});
    series.back().y.push_back(rival.ms);
  }
  return io::to_svg(chart);
}

void write_file(const std::filesystem::path& path, const std::string& text) {
  io::OutputFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace

int compare_solvers(const CompareOptions& options) {
  const Scene scene = chosen_scene(options.scene);
  if (scene.fluids.empty())
    throw Error(ErrorCode::invalid_argument,
                "compare needs a scene with a fluid; " + scene.name + " has none");
  const std::filesystem::path folder =
      options.out.empty() ? default_folder(scene) : std::filesystem::path(options.out);
  make_folder(folder);
  std::vector<double> errors = options.errors;
  std::sort(errors.begin(), errors.end());

  json figures{{"scene", scene.name}, {"seconds", options.seconds}, {"results", json::array()}};
  const DeviceInfo device = build_scene(prepared(scene, DensitySolver::chebyshev, 0)).world.device();
  figures["device"] = {{"kind", device.kind}, {"name", device.name}};
  std::string table =
      fmt::format("# {} for {:.4g} s on {}\n\n{}", scene.name, options.seconds, device.name, header);
  if (!options.json) fmt::print("{}", table);
  std::vector<Rival> rivals;
  for (const auto& solver : names_of(DensitySolver{})) {
    for (double error : errors) {
      rivals.push_back(result_of(scene, solver, error, options.seconds));
      table += row(rivals.back());
      if (!options.json) fmt::print("{}", row(rivals.back()));
      std::fflush(stdout);
      figures["results"].push_back(figures_of(rivals.back()));
    }
  }
  write_file(folder / "compare.md", table);
  write_file(folder / "compare.json", json_text(figures));
  write_file(folder / "compare.svg", chart_of(scene.name, errors, rivals));
  if (options.json) print_json(figures);
  return success;
}

}  // namespace meniscus::cli
